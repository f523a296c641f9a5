#pragma once

#include "geometry/triangle_triage.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// How far the triangles of eight pairs are apart.
struct Apart8 {
  Float8 at_least;  ///< certainly; may be negative or NaN, and then tells nothing
  Float8 about;     ///< squared, up to rounding of float
};

/// For a twentieth of the cost of `nearest_points`. The bound is good unless triangles are thin or
/// all but touch. Precondition: as for `triage`.
Apart8 how_far_apart(const TrianglePairs8& pairs);

}  // namespace PELT_TARGET
}  // namespace pelt::detail
