#pragma once

/// Divides pairs into islands, which have no common instances. Opened nodes of an island's
/// instances are useless for other islands, so they are discarded after the island. In a sparse
/// crowd, where islands are small, nodes therefore stay in the caches and need little memory.

#include <pelt/crowd.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

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
