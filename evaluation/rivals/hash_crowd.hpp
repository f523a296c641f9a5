#pragma once

/// Spatial hashing (hash.hpp) as its authors intend it: one grid for all bodies. The first query
/// after an update finds the contacts of all bodies: for one body after the other, looks up its
/// triangles among those of the bodies before it, then enters them. Leaves out triangles outside
/// all other bodies' boxes. Queries no pair of bodies separately, and needs no list of near pairs.
/// Limits on contacts work, but save little. Precondition of a query: all bodies have been updated.

#include "evaluation/rivals/posed_mesh_method.hpp"

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hash_crowd(const HashOptions& options = {});

}  // namespace pelt::rivals
