#include "evaluation/rivals/united_boxes.hpp"

#include <pelt/config.hpp>

namespace pelt::rivals {

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
