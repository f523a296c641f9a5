#include "self/pair_set.hpp"

#include <algorithm>

namespace pelt::detail {

void sort_unique(std::vector<std::uint64_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void PairSet::finish() {
  sort_unique(pairs_);
  pairs_.shrink_to_fit();
}

bool PairSet::contains(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(pairs_.begin(), pairs_.end(), packed(a, b));
}

}  // namespace pelt::detail
