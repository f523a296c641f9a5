#include "evaluation/reproduce/power_law.hpp"

#include "base/assert.hpp"

#include <cmath>
#include <vector>

namespace pelt::reproduce {

double fitted_exponent(std::span<const Measured> points) {
  std::vector<Measured> logs;
  Measured mean;
  for (const Measured& point : points) {
    if (point.size <= 0 || point.value <= 0) continue;
    logs.push_back({std::log(point.size), std::log(point.value)});
    mean.size += logs.back().size;
    mean.value += logs.back().value;
  }
  mean.size /= static_cast<double>(logs.size());
  mean.value /= static_cast<double>(logs.size());
  double product = 0, square = 0;
  for (const Measured& log : logs) {
    product += (log.size - mean.size) * (log.value - mean.value);
    square += (log.size - mean.size) * (log.size - mean.size);
  }
  PELT_ASSERT(square > 0);
  return product / square;
}

}  // namespace pelt::reproduce
