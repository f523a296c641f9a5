#include "self/neighbour_triage.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// For NeighbourSeparation.
struct FloatKit {
  using Number = Float8;
  using Point = Points8;
  using Mask = Mask8;

  static Float8 half() { return Float8(0.5f); }
  static Float8 third() { return Float8(1.0f / 3); }
  static Float8 determinant_units() { return Float8(0x1p-24f); }  // 128 e V, of 128 V
  static Float8 projection_units() { return Float8(0x1p-25f); }
  static Float8 tiny() { return Float8(0x1p-80f); }
  static Float8 min(const Float8& x, const Float8& y) { return detail::min(x, y); }
  static Float8 max(const Float8& x, const Float8& y) { return detail::max(x, y); }
  static Float8 largest(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }
};

}  // namespace

unsigned certainly_apart(const CornerNeighbours8& pairs) {
  return NeighbourSeparation<FloatKit>::are_apart(pairs).bits();
}

unsigned certainly_apart(const EdgeNeighbours8& pairs) {
  return NeighbourSeparation<FloatKit>::are_apart(pairs).bits();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
