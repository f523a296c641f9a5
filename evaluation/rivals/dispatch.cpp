#include <pelt/config.hpp>

#include "evaluation/rivals/touching.hpp"
#include "evaluation/rivals/tree_stages.hpp"
#include "evaluation/rivals/united_boxes.hpp"

namespace pelt::rivals {

namespace scalar {
Touching touching;
}
namespace simd128 {
Touching touching;
}
namespace avx2 {
Touching touching;
}

Touching* active_touching() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2) return avx2::touching;
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128) return simd128::touching;
#endif
  return scalar::touching;
}

namespace scalar {
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
}  // namespace scalar
namespace simd128 {
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
}  // namespace simd128
namespace avx2 {
DescendSelf descend_self;
BoxAllTriangles box_all_triangles;
}  // namespace avx2

DescendSelf* active_descend_self() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2) return avx2::descend_self;
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128) return simd128::descend_self;
#endif
  return scalar::descend_self;
}

BoxAllTriangles* active_box_all_triangles() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2) return avx2::box_all_triangles;
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128) return simd128::box_all_triangles;
#endif
  return scalar::box_all_triangles;
}

namespace scalar {
CollideUnited collide_united;
}  // namespace scalar
namespace simd128 {
CollideUnited collide_united;
}  // namespace simd128
namespace avx2 {
CollideUnited collide_united;
}  // namespace avx2

CollideUnited* active_collide_united() {
#ifdef PELT_HAS_AVX2
  if (active_instruction_set() == InstructionSet::avx2) return avx2::collide_united;
#endif
#ifdef PELT_HAS_SIMD128
  if (active_instruction_set() == InstructionSet::simd128) return simd128::collide_united;
#endif
  return scalar::collide_united;
}

}  // namespace pelt::rivals
