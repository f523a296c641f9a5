#include "self/pair_set.hpp"

#include <algorithm>

namespace pelt::detail {

void PairSet::finish() {
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  pairs_.shrink_to_fit();
}

bool PairSet::contains(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(pairs_.begin(), pairs_.end(), packed(a, b));
}

}  // namespace pelt::detail
