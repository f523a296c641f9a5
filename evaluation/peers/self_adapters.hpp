#pragma once

/// Other libraries, asked about a body against itself: `collide` is called with one body twice, and
/// finds each pair of triangles once, with the lower number first.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>

namespace pelt::peers {

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_mesh();

/// With Pelt's predicates; the same without pairs of neighbours; and with CGAL's predicate, without
/// pairs of neighbours.
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes();
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_apart();
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_own();

std::unique_ptr<rivals::PosedMeshMethod> make_self_embree();

}  // namespace pelt::peers
