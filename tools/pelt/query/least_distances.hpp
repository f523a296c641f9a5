#pragma once

#include <pelt/distance.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::query {

/// The distance of two colliders a < b in one frame.
struct PairDistance {
  std::uint32_t a = 0, b = 0;
  Distance distance = {};
  std::uint32_t frame = 0;
};

/// The pairs that came nearest, each once, by its least distance. Keeps only so many, however many
/// are added.
class LeastDistances {
 public:
  explicit LeastDistances(std::size_t most) : most_(most) {}

  void clear() { pairs_.clear(); }

  /// Of equal distances of one pair the first one added stays.
  void add(const PairDistance& pair);

  /// The nearest first; of equally near ones the lowest a, then b.
  std::span<const PairDistance> pairs() const { return pairs_; }

 private:
  std::size_t most_;
  std::vector<PairDistance> pairs_;
};

}  // namespace pelt::tools::query
