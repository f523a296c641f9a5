/// Upper bounds of the memory of queries.
///
/// A descent of two trees takes one step per level of the second tree, and at most two per level of
/// the first: one to a child, and one from there with the same node of the second tree. A step
/// replaces a pair by at most as many pairs as the two nodes have slots.

#include "query/scratch.hpp"

#include "model/clusters.hpp"
#include "model/tree.hpp"

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
  scratch_->positions.reserve(self.vertices);
  if (self.vertices > 0) scratch_->ring.reserve(2 * self.vertices + 1);
  if (self.triangles > 0) scratch_->outline_turns.reserve(2 * contacts);
  scratch_->turns_of.reserve(self.triangles);
  scratch_->fronts.reserve(self.triangles);
  scratch_->boxes.reserve(self.box_bytes);
}

}  // namespace pelt
