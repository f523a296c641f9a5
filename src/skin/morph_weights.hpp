#pragma once

#include "base/problem.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The weights of a mesh's morph targets in a pose, which have been checked: finite, and displacing
/// no vertex further than kMaxCoordinate. All zero at first.
class MorphWeights {
 public:
  /// `extents` [M]: for each target the sum over the axes of its largest displacement.
  explicit MorphWeights(std::span<const float> extents);

  /// What is wrong with `weights`, which nothing is done with; empty: nothing.
  Problem check(std::span<const float> weights) const;

  /// Precondition: `check` finds nothing wrong.
  void set(std::span<const float> weights);

  std::size_t count() const { return weights_.size(); }
  std::span<const float> all() const { return weights_; }
  float operator[](std::uint32_t target) const { return weights_[target]; }

  /// The targets whose weight is not zero, ascending.
  std::span<const std::uint32_t> active() const { return active_; }
  bool any() const { return !active_.empty(); }

  /// Sum of |weight| x extent: no displacement has coordinates that sum to more.
  double extent_of(std::span<const float> weights) const;

  std::size_t memory_bytes() const;

 private:
  std::vector<float> extents_, weights_;
  std::vector<std::uint32_t> active_;
};

}  // namespace pelt::detail
