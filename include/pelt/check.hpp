#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>

#include <string>

namespace pelt {

/// Checks the bounds of a pose, for tests. Computes every bound of `pose` that a query could use,
/// compares these bounds and those stored in the pose with the positions of `posed_vertices`, and
/// leaves the pose unchanged.
///
/// Returns an empty string if every bound encloses its vertices. Otherwise returns a message with
/// the node, bound and distance of the first violation. A violation is a bug in Pelt.
///
/// Cost: O(T + V). Allocates.
PELT_API std::string check_bounds(const Pose& pose);

}  // namespace pelt
