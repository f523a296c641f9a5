#include "crowd/islands.hpp"

#include "base/bytes_held.hpp"
#include "base/disjoint_sets.hpp"

#include <algorithm>
#include <numeric>

namespace pelt::detail {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

}  // namespace

/// Forms the islands in the order of their first pairs, by counting sort.
void Islands::form(std::span<const CrowdPair> pairs, std::uint32_t instance_end) {
  DisjointSets sets(instance_end, leaders_);
  for (const CrowdPair& pair : pairs) sets.join(pair.instance_a, pair.instance_b);

  island_of_.assign(instance_end, kNone);
  begins_.assign(1, 0);
  for (const CrowdPair& pair : pairs) {
    std::uint32_t& island = island_of_[sets.find(pair.instance_a)];
    if (island == kNone) {
      island = count();
      begins_.push_back(0);
    }
    ++begins_[island + 1];
  }
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());

  pairs_.resize(pairs.size());
  for (const CrowdPair& pair : pairs)
    pairs_[begins_[island_of_[sets.find(pair.instance_a)]]++] = pair;
  std::copy_backward(begins_.begin(), begins_.end() - 1, begins_.end());
  begins_[0] = 0;
}

std::size_t Islands::memory_bytes() const {
  return bytes_held(leaders_, island_of_, begins_, pairs_);
}

}  // namespace pelt::detail
