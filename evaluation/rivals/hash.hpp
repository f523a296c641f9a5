#pragma once

/// Teschner, Heidelberger, Mueller, Pomeranets & Gross 2003, "Optimized spatial hashing for
/// collision detection of deformable objects", section 4. Every update enters the boxes of a body's
/// triangles into all cells of a grid that they touch. The cell (i, j, k) is at index (i 73856093
/// xor j 19349663 xor k 83492791) mod n of a table. The triangles of another body are looked up
/// there.
///
/// Strengthened: entries store their cell, so entries of other cells at the same index are skipped
/// without testing their boxes; n is a power of two and at least twice the number of triangles;
/// bodies whose boxes do not overlap are not looked up, nor are triangles outside the other body's
/// box; a body is entered when another is first looked up in it, so only one body of a pair is
/// entered.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>

namespace pelt::rivals {

struct HashOptions {
  /// Edge of a cell over the mean edge of the mesh at rest.
  float cell_edges = 3;
};

std::unique_ptr<PosedMeshMethod> make_hash(const HashOptions& options = {});

}  // namespace pelt::rivals
