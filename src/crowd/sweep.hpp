#pragma once

/// The broad phase, which finds overlapping boxes. Boxes are sorted by their low ends along the
/// axis with the largest spread. Each box is then compared, eight at a time, with those that start
/// before it ends (sweep and prune; Ericson 2005, section 7.5).

#include <pelt/crowd.hpp>

#include "pose/pose_boxes.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

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

}  // namespace pelt::detail
