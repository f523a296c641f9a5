#pragma once

/// The broad phase: finds pairs of instances whose boxes overlap, and divides the pairs into
/// islands. The door of this room.

#include <pelt/crowd.hpp>

#include "pose/pose_boxes.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Finds overlapping boxes. Boxes are sorted by their low ends along the axis with the largest
/// spread. Each box is then compared, eight at a time, with those that start before it ends (sweep
/// and prune; Ericson 2005, section 7.5).
class Sweep {
 public:
  void clear() { boxes_.clear(); }

  void add(std::uint32_t instance, const RootBox& box);

  /// Replaces `pairs` with the pairs a < b whose boxes overlap; touching counts. Neighbouring pairs
  /// are close to each other in the list.
  void find_pairs(std::vector<CrowdPair>& pairs);

  std::size_t memory_bytes() const;

 private:
  struct Box {
    float low[3], high[3];
    std::uint32_t instance;
  };

  void sort_along(int axis);
  void find_partners(std::size_t index, int axis, std::vector<CrowdPair>& pairs) const;

  std::vector<Box> boxes_;
  // The boxes in structure-of-arrays order, padded with lanes that overlap nothing.
  std::vector<float> low_[3], high_[3];
};

/// Divides pairs into islands, which have no common instances. Opened nodes of an island's
/// instances are useless for other islands, so they are discarded after the island. In a sparse
/// crowd, where islands are small, nodes therefore stay in the caches and need little memory.
class Islands {
 public:
  /// Divides `pairs` of instances below `instance_end`. Pairs of an island keep their order.
  void form(std::span<const CrowdPair> pairs, std::uint32_t instance_end);

  std::uint32_t count() const { return static_cast<std::uint32_t>(begins_.size()) - 1; }
  std::span<const CrowdPair> operator[](std::uint32_t island) const {
    return std::span(pairs_).subspan(begins_[island], begins_[island + 1] - begins_[island]);
  }

  std::size_t memory_bytes() const;

 private:
  std::vector<std::uint32_t> leaders_;       // memory of the sets of instances
  std::vector<std::uint32_t> island_of_;     // of each leader
  std::vector<std::uint32_t> begins_ = {0};  // into pairs_; then the end
  std::vector<CrowdPair> pairs_;
};

}  // namespace pelt::detail
