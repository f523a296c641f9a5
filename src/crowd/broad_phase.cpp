#include "crowd/broad_phase.hpp"

#include "base/bytes_held.hpp"
#include "base/disjoint_sets.hpp"
#include "base/float8.hpp"
#include "query/slots.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pelt::detail {
namespace {

constexpr std::size_t kLanes = 8;

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Returns the axis with the largest variance of the boxes' low ends.
template <typename Boxes>
int widest_axis(const Boxes& boxes) {
  double sum[3] = {}, squares[3] = {};
  for (const auto& box : boxes)
    for (int axis = 0; axis < 3; ++axis) {
      const double low = static_cast<double>(box.low[axis]);
      sum[axis] += low;
      squares[axis] += low * low;
    }
  const double count = static_cast<double>(boxes.size());
  double variance[3];
  for (int axis = 0; axis < 3; ++axis)
    variance[axis] = squares[axis] * count - sum[axis] * sum[axis];
  return static_cast<int>(std::max_element(variance, variance + 3) - variance);
}

}  // namespace

void Sweep::add(std::uint32_t instance, const RootBox& box) {
  boxes_.push_back(
      {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}, instance});
}

void Sweep::find_pairs(std::vector<CrowdPair>& pairs) {
  pairs.clear();
  const int axis = widest_axis(boxes_);
  sort_along(axis);
  for (std::size_t i = 0; i < boxes_.size(); ++i) find_partners(i, axis, pairs);
}

void Sweep::sort_along(int axis) {
  std::sort(boxes_.begin(), boxes_.end(), [axis](const Box& a, const Box& b) {
    return a.low[axis] < b.low[axis] || (a.low[axis] == b.low[axis] && a.instance < b.instance);
  });
  for (int k = 0; k < 3; ++k) {
    low_[k].clear();
    high_[k].clear();
    for (const Box& box : boxes_) {
      low_[k].push_back(box.low[k]);
      high_[k].push_back(box.high[k]);
    }
    low_[k].resize(boxes_.size() + kLanes, HUGE_VALF);
    high_[k].resize(boxes_.size() + kLanes, -HUGE_VALF);
  }
}

/// Finds the boxes after `index` in the order that overlap it.
void Sweep::find_partners(std::size_t index, int axis, std::vector<CrowdPair>& pairs) const {
  const Box& box = boxes_[index];
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  for (std::size_t first = index + 1; low_[axis][first] <= box.high[axis]; first += kLanes) {
    const auto low = [&](int k) { return load8(&low_[k][first]); };
    const auto high = [&](int k) { return load8(&high_[k][first]); };
    const Mask8 overlaps =
        (low(axis) <= Float8(box.high[axis])) & (low(next) <= Float8(box.high[next])) &
        (Float8(box.low[next]) <= high(next)) & (low(last) <= Float8(box.high[last])) &
        (Float8(box.low[last]) <= high(last));
    for (SetBits lane(overlaps.bits()); lane; ++lane) {
      const std::uint32_t other = boxes_[first + *lane].instance;
      pairs.push_back({std::min(box.instance, other), std::max(box.instance, other)});
    }
    if (first + kLanes >= boxes_.size()) break;
  }
}

std::size_t Sweep::memory_bytes() const {
  return bytes_held(boxes_, low_[0], low_[1], low_[2], high_[0], high_[1], high_[2]);
}

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
