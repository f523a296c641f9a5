#pragma once

/// Pairs put into groups that have no instance in common: what is opened of a group's instances is
/// of no use to any other group, so it can be forgotten as soon as the group is through. That keeps
/// the nodes of a sparse crowd, where groups are small, in the caches and off the memory.

#include <pelt/crowd.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

class PairGroups {
 public:
  /// Takes pairs of instances below `instance_end`. Within a group they keep their order.
  void form(std::span<const CrowdPair> pairs, std::uint32_t instance_end);

  std::uint32_t count() const { return static_cast<std::uint32_t>(begins_.size()) - 1; }
  std::span<const CrowdPair> operator[](std::uint32_t group) const {
    return std::span(pairs_).subspan(begins_[group], begins_[group + 1] - begins_[group]);
  }

  std::size_t memory_bytes() const;

 private:
  std::vector<std::uint32_t> leaders_;       // memory of the sets of instances
  std::vector<std::uint32_t> group_of_;      // of each leader
  std::vector<std::uint32_t> begins_ = {0};  // into pairs_, one more than there are groups
  std::vector<CrowdPair> pairs_;
};

}  // namespace pelt::detail
