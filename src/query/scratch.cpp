/// Upper bounds of the memory of queries.
///
/// A descent of two trees takes one step per level of the second tree, and at most two per level of
/// the first: one to a child, and one from there with the same node of the second tree. A step
/// replaces a pair by at most as many pairs as the two nodes have slots.

#include "query/scratch.hpp"

#include <pelt/search.hpp>

#include "model/clusters.hpp"
#include "model/tree.hpp"
#include "query/stack.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace pelt {

QueryStats& QueryStats::operator+=(const QueryStats& other) {
  node_pairs += other.node_pairs;
  refits += other.refits;
  posed_vertices += other.posed_vertices;
  triangle_pairs += other.triangle_pairs;
  displacements += other.displacements;
  clamped_offsets += other.clamped_offsets;
  cut_short = cut_short || other.cut_short;
  return *this;
}

std::uint64_t work_of(const QueryStats& stats) {
  return kNodePairWork * stats.node_pairs + kRefitWork * stats.refits +
         kPosedVertexWork * stats.posed_vertices + kTrianglePairWork * stats.triangle_pairs +
         kDisplacementWork * stats.displacements;
}

}  // namespace pelt

namespace pelt::detail {

void StackMemory::grow(std::size_t item_bytes) {
  reserve(std::max<std::size_t>(64, 2 * capacity_), item_bytes);
}

/// The product must not wrap around. No machine has kMax bytes, so `new` then throws.
void StackMemory::reserve(std::size_t capacity, std::size_t item_bytes) {
  constexpr std::size_t kMax = std::numeric_limits<std::ptrdiff_t>::max();
  if (capacity <= capacity_) return;
  const std::size_t size = capacity <= kMax / item_bytes ? capacity * item_bytes : kMax;
  std::unique_ptr<std::byte[]> bytes(new std::byte[size]);
  if (size_ > 0) std::memcpy(bytes.get(), bytes_.get(), size_ * item_bytes);
  bytes_ = std::move(bytes);
  capacity_ = capacity;
}

}  // namespace pelt::detail

namespace pelt {
namespace {

constexpr std::size_t kMaxSlotPairs =
    std::size_t{3} * detail::kMaxClusterTreeDepth * 2 * detail::kMaxSlots;

/// For one tree, a step replaces a node by its children.
constexpr std::size_t kMaxNodes = std::size_t{detail::kMaxClusterTreeDepth} * detail::kMaxSlots;

/// A nearest-first search replaces one part by its slots.
constexpr std::size_t kMaxNearParts =
    std::size_t{detail::kMaxClusterTreeDepth + 1} * detail::kMaxSlots;

/// A query with a limit checks its count between pairs of clusters. Before, 16 pairs of clusters of
/// one pose (self/cluster_pairs.hpp) and seven pairs of triangles may have been waiting.
constexpr std::size_t kMaxBeyond =
    std::size_t{16} * detail::kMaxClusterTriangles * detail::kMaxClusterTriangles + 7;

/// A query of motions checks its count after each pair of clusters.
constexpr std::size_t kMaxMovingBeyond =
    std::size_t{detail::kMaxClusterTriangles} * detail::kMaxClusterTriangles + 7;

}  // namespace

Scratch::Scratch() : scratch_(std::make_unique<detail::Scratch>()) {}
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;
Scratch::~Scratch() = default;

void Scratch::reserve(std::size_t contacts, std::size_t ray_hits, const SelfScratchSize& self) {
  scratch_->slot_pairs.reserve(kMaxSlotPairs);
  scratch_->near_part.reserve(kMaxNearParts);
  scratch_->near_parts.reserve(2 * kMaxNearParts);
  scratch_->found.reserve(contacts + kMaxBeyond);
  scratch_->sorting.reserve(contacts);
  scratch_->moving.reserve(contacts + kMaxMovingBeyond);
  scratch_->sorting_moving.reserve(contacts);
  scratch_->ray_hits.reserve(ray_hits);
  scratch_->nodes.reserve(kMaxNodes);
  scratch_->touching.reserve(contacts);
  scratch_->inside.reserve(contacts);
  scratch_->sorting_numbers.reserve(contacts);
  scratch_->turns_a.reserve(contacts);
  scratch_->turns_b.reserve(contacts);
  scratch_->positions.reserve(2 * self.vertices);  // at both ends of a motion
  if (self.vertices > 0) scratch_->ring.reserve(2 * self.vertices + 1);
  if (self.triangles > 0) scratch_->outline_turns.reserve(2 * contacts);
  scratch_->turns_of.reserve(self.triangles);
  scratch_->fronts.reserve(self.triangles);
  scratch_->boxes.reserve(self.box_bytes);
}

}  // namespace pelt
