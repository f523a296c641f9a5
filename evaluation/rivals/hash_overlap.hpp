#pragma once

/// Spatial hashing (hash.hpp) where it matters alone: nothing is entered at an update; a query
/// takes those triangles of both bodies that reach into the intersection of the bodies' boxes,
/// finds the cells of it that both bodies touch (common_cells.hpp), and sorts one body's triangles
/// into these by counting. There are no chains, no hash, and no table larger than what is sorted.
/// Who wants one contact gets it from the first slab of the intersection that has one: a pair may
/// be found in two slabs, which then does not matter, and what lies beyond is not sorted.

#include "evaluation/rivals/hash.hpp"

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options = {});

}  // namespace pelt::rivals
