/// The gap between the projections of two triangles onto a direction n, divided by |n|, is a lower
/// bound of their distance.
///
/// Rounding. All corners are taken relative to one of them, and divided by the largest coordinate L
/// of these. With e = 2^-24, the computed reciprocal of L has a relative error of e, which changes
/// only the scale, by the same factor for all corners. n is any float vector. A position along n
/// has an error of at most 5.1 e |n|_1: two roundings of the corner, one of a product, two of sums.
/// The difference of two positions is at most 2 |n|_1 and is rounded once more, so its error is
/// below 13 e |n|_1. The margin 2^-19 |n|_1 = 32 e |n|_1 is more than twice that.
///
/// gap^2 / n^2 has at most 7 relative errors e. The root halves them and adds one. The scale, and
/// the products with L and with 1 - 2^-20, add three. These are 7.5 e, and 1 - 2^-20 = 1 - 16 e
/// covers them.
///
/// Products that underflow add at most 2^-149 |n|_1 each, which the margin covers. If the area is
/// zero, or the reciprocal of L or of the area's largest coordinate overflows, then all coordinates
/// of n are NaN or infinite. Then n^2 fails its test, whatever min and max make of a NaN.

#include "self/triangle_separation.hpp"

#include "geometry/points8.hpp"

#include <initializer_list>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

Points8 abs8(const Points8& p) { return {abs(p.x), abs(p.y), abs(p.z)}; }
Float8 largest_of(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }
Float8 min3(const Float8& a, const Float8& b, const Float8& c) { return min(min(a, b), c); }
Float8 max3(const Float8& a, const Float8& b, const Float8& c) { return max(max(a, b), c); }

class Separation {
 public:
  explicit Separation(const TrianglePairs8& pairs)
      : a1_(pairs.a[1] - pairs.a[0]),
        a2_(pairs.a[2] - pairs.a[0]),
        b0_(pairs.b[0] - pairs.a[0]),
        b1_(pairs.b[1] - pairs.a[0]),
        b2_(pairs.b[2] - pairs.a[0]),
        size_(max(max(largest_of(a1_), largest_of(a2_)),
                  max3(largest_of(b0_), largest_of(b1_), largest_of(b2_)))) {
    const Float8 scale = Float8(1.0f) / size_;
    for (Points8* p : {&a1_, &a2_, &b0_, &b1_, &b2_}) *p = scale * *p;
  }

  void try_plane_of(const Points8& edge0, const Points8& edge1, const Points8& edge2) {
    const Points8 area = cross(edge0, edge1);
    const Points8 normal = Float8(1.0f) / largest_of(area) * area;
    try_direction(normal);
    try_direction(cross(edge0, normal));
    try_direction(cross(edge1, normal));
    try_direction(cross(edge2, normal));
  }

  Float8 largest() {
    try_plane_of(a1_, a2_ - a1_, a2_);
    try_plane_of(b1_ - b0_, b2_ - b1_, b2_ - b0_);
    return select(Float8(0.0f) < squared_, sqrt(squared_) * size_ * Float8(1 - 0x1p-20f),
                  Float8(0.0f));
  }

 private:
  void try_direction(const Points8& n) {
    const Float8 a1 = dot(n, a1_), a2 = dot(n, a2_), zero(0.0f);
    const Float8 b0 = dot(n, b0_), b1 = dot(n, b1_), b2 = dot(n, b2_);
    const Float8 beyond = min3(b0, b1, b2) - max3(a1, a2, zero);
    const Float8 before = min3(a1, a2, zero) - max3(b0, b1, b2);
    const Points8 sizes = abs8(n);
    const Float8 gap = max(beyond, before) - Float8(0x1p-19f) * (sizes.x + sizes.y + sizes.z);
    const Float8 squared_n = dot(n, n);
    const Mask8 is_certain = (Float8(0x1p-50f) < gap) & (gap < Float8(0x1p50f)) &
                             (Float8(0x1p-100f) < squared_n) & (squared_n < Float8(0x1p100f));
    squared_ = select(is_certain, max(squared_, gap * gap / squared_n), squared_);
  }

  Points8 a1_, a2_, b0_, b1_, b2_;  // relative to the first corner of a, divided by size_
  Float8 size_;
  Float8 squared_ = Float8(0.0f);
};

}  // namespace

Float8 separations(const TrianglePairs8& pairs) { return Separation(pairs).largest(); }

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
