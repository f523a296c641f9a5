#include "evaluation/rivals/touching.hpp"

#include <pelt/config.hpp>

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

}  // namespace pelt::rivals
