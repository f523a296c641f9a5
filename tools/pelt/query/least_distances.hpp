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

/// The closest pairs, each once, with its least distance. Stores at most a fixed number of pairs.
class LeastDistances {
 public:
  /// Stores at most `most` pairs.
  explicit LeastDistances(std::size_t most) : most_(most) {}

  void clear() { pairs_.clear(); }

  /// Adds a pair. If it was added before with an equal distance, the earlier one stays.
  void add(const PairDistance& pair);

  /// Whether pairs were left out since the construction because there were too many.
  bool has_left_out() const { return has_left_out_; }

  /// Sorted by distance, then a, then b.
  std::span<const PairDistance> pairs() const { return pairs_; }

 private:
  std::size_t most_;
  bool has_left_out_ = false;
  std::vector<PairDistance> pairs_;
};

}  // namespace pelt::tools::query
