#pragma once

/// Teschner, Heidelberger, Mueller, Pomeranets & Gross 2003, "Optimized spatial hashing for
/// collision detection of deformable objects", section 4: at every update the boxes of a body's
/// triangles are entered in all cells of a grid that they touch; the cell (i, j, k) is kept in the
/// place (i 73856093 xor j 19349663 xor k 83492791) mod n of a table. The triangles of another body
/// are looked up there.
///
/// Strengthened: entries know their cell, so that what merely shares a place is passed over without
/// a look at its box; n is a power of two at least twice the number of triangles; bodies whose
/// boxes are apart are not looked up, nor are triangles outside the other body's box; a body is
/// entered when another is first looked up in it, so that of a pair one is.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>

namespace pelt::rivals {

struct HashOptions {
  /// Edge of a cell over the mean edge of the mesh at rest.
  float cell_edges = 3;
};

std::unique_ptr<PosedMeshMethod> make_hash(const HashOptions& options = {});

}  // namespace pelt::rivals
