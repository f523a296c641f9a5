#pragma once

/// The broad phase: which of many boxes overlap. Boxes are sorted by their low ends along the axis
/// on which they are spread most; each is then compared, eight at once, with those that begin
/// before it ends (sweep and prune; Ericson 2005, section 7.5).

#include <pelt/crowd.hpp>

#include "pose/root_box.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

class Sweep {
 public:
  void clear() { boxes_.clear(); }

  void add(std::uint32_t instance, const RootBox& box);

  /// Replaces `pairs` by those whose boxes overlap, a < b; touching counts. Pairs near each other
  /// in space stand near each other.
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
  // The same, side by side, with lanes that overlap nothing at the end.
  std::vector<float> low_[3], high_[3];
};

}  // namespace pelt::detail
