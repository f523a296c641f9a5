#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>

#include <string>

namespace pelt {

/// Looks for a bound that leaves out a posed vertex: computes every bound of `pose`, whether
/// queries have asked for it or not, and compares it and those that queries have left in the pose
/// with the positions of `posed_vertices`.
///
/// Returns what it found first, naming the node, the bound and the distance; empty when all bounds
/// are sound, and anything else is a bug of Pelt. For tests: O(T + V) and no less, allocates,
/// leaves the pose as it is.
PELT_API std::string check_bounds(const Pose& pose);

}  // namespace pelt
