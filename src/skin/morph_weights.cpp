#include "skin/morph_weights.hpp"

#include "base/bytes_held.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {

MorphWeights::MorphWeights(std::span<const float> extents)
    : extents_(extents.begin(), extents.end()), weights_(extents.size()) {
  active_.reserve(extents.size());
}

Problem MorphWeights::check(std::span<const float> weights) const {
  if (weights.size() != count())
    return problem("morph_weights has %zu elements, expected %zu: one for each morph target",
                   weights.size(), count());
  for (std::size_t m = 0; m < weights.size(); ++m)
    if (!std::isfinite(weights[m]))
      return problem("morph_weights[%zu] is %g", m, static_cast<double>(weights[m]));
  if (extent_of(weights) <= static_cast<double>(kMaxCoordinate)) return {};
  std::size_t farthest = 0;
  for (std::size_t m = 0; m < weights.size(); ++m)
    if (std::fabs(weights[m]) * extents_[m] > std::fabs(weights[farthest]) * extents_[farthest])
      farthest = m;
  return problem("morph_weights[%zu] of %g, with the others, can displace a vertex by 2^60 units",
                 farthest, static_cast<double>(weights[farthest]));
}

void MorphWeights::set(std::span<const float> weights) {
  std::copy(weights.begin(), weights.end(), weights_.begin());
  active_.clear();
  for (std::uint32_t m = 0; m < weights.size(); ++m)
    if (weights[m] != 0) active_.push_back(m);
}

double MorphWeights::extent_of(std::span<const float> weights) const {
  double sum = 0;
  for (std::size_t m = 0; m < weights.size(); ++m)
    sum += std::fabs(static_cast<double>(weights[m])) * static_cast<double>(extents_[m]);
  return sum;
}

std::size_t MorphWeights::memory_bytes() const { return bytes_held(extents_, weights_, active_); }

}  // namespace pelt::detail
