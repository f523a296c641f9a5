#include <pelt/config.hpp>

#include "evaluation/rivals/stages.hpp"

namespace pelt::rivals {

namespace scalar {
Touching touching;
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
CollideUnited collide_united;
}  // namespace scalar
namespace simd128 {
Touching touching;
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
CollideUnited collide_united;
}  // namespace simd128
namespace avx2 {
Touching touching;
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
CollideUnited collide_united;
}  // namespace avx2

namespace {

/// The functions for one instruction set.
struct Stages {
  Touching* touching;
  DescendSelf* descend_self;
  BoxAllTriangles* box_all_triangles;
  CollideUnited* collide_united;
};

Stages active() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2)
    return {avx2::touching, avx2::descend_self, avx2::box_all_triangles, avx2::collide_united};
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128)
    return {simd128::touching, simd128::descend_self, simd128::box_all_triangles,
            simd128::collide_united};
#endif
  return {scalar::touching, scalar::descend_self, scalar::box_all_triangles,
          scalar::collide_united};
}

}  // namespace

Touching* active_touching() { return active().touching; }
DescendSelf* active_descend_self() { return active().descend_self; }
BoxAllTriangles* active_box_all_triangles() { return active().box_all_triangles; }
CollideUnited* active_collide_united() { return active().collide_united; }

}  // namespace pelt::rivals
