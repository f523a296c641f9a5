#pragma once

/// Spatial hashing (hash.hpp) where it matters alone: nothing is entered at an update; a query
/// takes those triangles of both bodies that reach into the intersection of the bodies' boxes, and
/// sorts one body's into cells of that box by counting. There are no chains, no hash and no table
/// larger than what is sorted: cells are larger where there would be more than a few for each
/// triangle.

#include "rivals/hash.hpp"

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options = {});

}  // namespace pelt::rivals
