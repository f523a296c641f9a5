#pragma once

/// Arithmetic on eight points or vectors side by side, and the signs of determinants of eight pairs
/// of triangles, as far as they are certain.

#include "base/float8.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

inline Points8 operator+(const Points8& p, const Points8& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline Points8 operator-(const Points8& p, const Points8& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Points8 operator*(const Float8& s, const Points8& p) { return {s * p.x, s * p.y, s * p.z}; }

inline Points8 cross(const Points8& p, const Points8& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

inline Float8 dot(const Points8& p, const Points8& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

inline Points8 select(const Mask8& mask, const Points8& yes, const Points8& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

inline constexpr unsigned kAllLanes = 0xFF;

/// A value for each corner of a triangle, or for each edge: edge i leads from corner i to the next.
using Three = Float8[3];

inline Float8 lowest(const Three& v) { return min(min(v[0], v[1]), v[2]); }
inline Float8 highest(const Three& v) { return max(max(v[0], v[1]), v[2]); }
inline Float8 sum(const Three& v) { return v[0] + v[1] + v[2]; }

/// A choice of one edge in each lane.
struct Edge {
  Mask8 is_first, is_second;

  Float8 of(const Three& values) const {
    return select(is_first, values[0], select(is_second, values[1], values[2]));
  }
};

/// Determines which signs are certain, of values whose error is below a bound.
class Certainty {
 public:
  explicit Certainty(const Float8& error) : error_(error), minus_error_(Float8(0.0f) - error) {}

  Mask8 positive(const Float8& value) const { return error_ < value; }
  Mask8 negative(const Float8& value) const { return value < minus_error_; }

  Mask8 all_one_sign(const Three& v) const { return positive(lowest(v)) | negative(highest(v)); }
  Mask8 all_some_sign(const Three& v) const {
    return positive(lowest({abs(v[0]), abs(v[1]), abs(v[2])}));
  }

  /// The bound of one lane, in all lanes.
  Certainty of_lane(unsigned lane) const { return Certainty(Float8(lane_of(error_, lane))); }

  Edge edge_down(const Three& heights) const {
    return {positive(heights[0]) & negative(heights[1]),
            positive(heights[1]) & negative(heights[2])};
  }
  Edge edge_up(const Three& heights) const {
    return {negative(heights[0]) & positive(heights[1]),
            negative(heights[1]) & positive(heights[2])};
  }

 private:
  Float8 error_, minus_error_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
