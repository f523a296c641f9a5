#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelt::detail {

void sort_unique(std::vector<std::uint64_t>& numbers);

/// A set of unordered pairs of numbers. Pairs are packed into integers, so that sets of all kinds
/// of numbers share one instance of std::sort, which takes kilobytes.
class PairSet {
 public:
  using value_type = std::uint64_t;

  void reserve(std::size_t count) { pairs_.reserve(count); }
  void add(std::uint32_t a, std::uint32_t b) { pairs_.push_back(packed(a, b)); }

  /// Sorts the pairs and removes repetitions. Call this after the last `add`.
  void finish();

  bool empty() const { return pairs_.empty(); }
  bool contains(std::uint32_t a, std::uint32_t b) const;
  std::size_t capacity() const { return pairs_.capacity(); }

 private:
  static std::uint64_t packed(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
  }

  std::vector<std::uint64_t> pairs_;
};

}  // namespace pelt::detail
