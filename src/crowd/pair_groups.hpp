#pragma once

/// Divides pairs into connected groups without common instances. Opened nodes of a group's
/// instances are useless for other groups, so they are discarded after the group. In a sparse
/// crowd, where groups are small, nodes therefore stay in the caches and need little memory.

#include <pelt/crowd.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

class PairGroups {
 public:
  /// Divides `pairs` of instances below `instance_end`. Pairs of a group keep their order.
  void form(std::span<const CrowdPair> pairs, std::uint32_t instance_end);

  std::uint32_t count() const { return static_cast<std::uint32_t>(begins_.size()) - 1; }
  std::span<const CrowdPair> operator[](std::uint32_t group) const {
    return std::span(pairs_).subspan(begins_[group], begins_[group + 1] - begins_[group]);
  }

  std::size_t memory_bytes() const;

 private:
  std::vector<std::uint32_t> leaders_;       // memory of the sets of instances
  std::vector<std::uint32_t> group_of_;      // of each leader
  std::vector<std::uint32_t> begins_ = {0};  // into pairs_; then the end
  std::vector<CrowdPair> pairs_;
};

}  // namespace pelt::detail
