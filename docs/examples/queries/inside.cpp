#include <pelt/inside.hpp>

// How deep `a` is inside the closed surface of `b`; 0 if no vertex of `a` is inside.
double depth_in(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch) {
  pelt::Penetration deepest;
  pelt::deepest_vertex(a, b, scratch, deepest);
  return deepest.depth;  // deepest.position and deepest.closest say where
}
