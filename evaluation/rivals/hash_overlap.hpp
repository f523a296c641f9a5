#pragma once

/// Spatial hashing (hash.hpp) restricted to the overlap of two bodies. An update enters nothing. A
/// query selects the triangles of both bodies that reach into the intersection of the bodies'
/// boxes, finds the cells of the intersection that both bodies touch (common_cells.hpp), and sorts
/// one body's triangles into these cells by counting. There are no chains, no hash, and no table
/// larger than the sorted triangles. If one contact suffices, the query processes the intersection
/// slab by slab and stops at the first slab with a contact; a pair that lies in two slabs is
/// harmless then.

#include "evaluation/rivals/hash.hpp"

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options = {});

}  // namespace pelt::rivals
