#pragma once

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Disjoint sets of the numbers below a count, in borrowed memory. A set is named by its least
/// member.
class DisjointSets {
 public:
  /// Makes a set of each number.
  DisjointSets(std::uint32_t count, std::vector<std::uint32_t>& memory) : parents_(memory) {
    parents_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) parents_[i] = i;
  }

  std::uint32_t find(std::uint32_t number) {
    while (parents_[number] != number) {
      parents_[number] = parents_[parents_[number]];
      number = parents_[number];
    }
    return number;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    (a < b ? parents_[b] : parents_[a]) = a < b ? a : b;
  }

 private:
  std::vector<std::uint32_t>& parents_;
};

}  // namespace pelt::detail
