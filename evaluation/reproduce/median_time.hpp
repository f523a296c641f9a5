#pragma once

#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <cstdint>
#include <vector>

namespace pelt::reproduce {

/// Duration of `work` in microseconds: the median of `repetitions` runs.
template <typename Work>
double median_us(std::uint32_t repetitions, const Work& work) {
  std::vector<double> times;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    tools::bench::Stopwatch watch;
    work();
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return tools::output::median(times);
}

}  // namespace pelt::reproduce
