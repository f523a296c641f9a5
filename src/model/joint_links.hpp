#pragma once

#include "model/tree.hpp"
#include "skin/joint_link.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Finds the pairs of joints that share a vertex, in ascending order. O(P K^2 log P) for P vertices
/// in pools with K influences.
std::vector<JointLink> find_joint_links(const Tree& tree);

/// Returns the number of the link of two joints. Precondition: they are linked.
std::uint32_t link_of(std::span<const JointLink> links, std::uint16_t a, std::uint16_t b);

}  // namespace pelt::detail
