#pragma once

#include "base/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Validated weights of a mesh's morph targets in a pose: finite, and displacing no vertex farther
/// than kMaxCoordinate. Initially all zero.
class MorphWeights {
 public:
  /// `extents` [M]: for each target the sum over the axes of its largest displacement.
  explicit MorphWeights(std::span<const float> extents);

  /// Validates `weights` without storing them. Returns an empty Problem if they are valid.
  Problem check(std::span<const float> weights) const;

  /// Stores the weights. Precondition: `check` returns no problem.
  void set(std::span<const float> weights);

  std::size_t count() const { return weights_.size(); }
  std::span<const float> all() const { return weights_; }
  float operator[](std::uint32_t target) const { return weights_[target]; }

  /// The targets with nonzero weight, in ascending order.
  std::span<const std::uint32_t> active() const { return active_; }
  bool any() const { return !active_.empty(); }

  /// Sum of |weight| x extent, an upper bound of the sum of coordinates of any displacement.
  double extent_of(std::span<const float> weights) const;

  std::size_t memory_bytes() const;

 private:
  std::vector<float> extents_, weights_;
  std::vector<std::uint32_t> active_;
};

}  // namespace pelt::detail
