#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>

#include <string>

namespace pelt {

/// Checks that the bounds of a pose enclose its posed vertices (see `posed_vertices`), for use in
/// tests. First checks the bounds that earlier queries have stored in `pose`, and then all bounds
/// that a query could compute. Leaves `pose` unchanged.
///
/// Returns an empty string if every bound encloses its vertices. Otherwise returns a message about
/// the first violation, with the node, the bound, and how far a vertex is outside the bound. A
/// violation is a bug in Pelt.
///
/// Cost: O(T + V). Allocates.
PELT_API std::string check_bounds(const Pose& pose);

}  // namespace pelt
