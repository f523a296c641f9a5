#pragma once

/// Four floats processed in parallel. The scalar twin (PELT_SCALAR) performs the same operations in
/// the same order, so both give the same bits.

#include "base/instruction_set.hpp"

#include <cmath>
#include <cstring>

#if defined(__SSE2__) && !defined(PELT_SCALAR)
#include <emmintrin.h>
#elif defined(__wasm_simd128__) && !defined(PELT_SCALAR)
#include <wasm_simd128.h>
#endif

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

#ifdef PELT_SCALAR

struct Lanes {
  float lane[4];

  float operator[](int i) const { return lane[i]; }
};

template <typename Operation>
Lanes each_lane(const Lanes& a, const Lanes& b, Operation operation) {
  return {
      {operation(a[0], b[0]), operation(a[1], b[1]), operation(a[2], b[2]), operation(a[3], b[3])}};
}

inline Lanes operator+(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x + y; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x - y; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x * y; });
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x / y; });
}
inline Lanes lower(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Lanes higher(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Lanes magnitude(const Lanes& a) {
  return {{std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2]), std::fabs(a[3])}};
}
inline Lanes rotated(const Lanes& a) { return {{a[1], a[2], a[0], a[3]}}; }
inline Lanes make_lanes(float x, float y, float z, float w) { return {{x, y, z, w}}; }

/// A boolean for each lane.
struct Mask4 {
  bool lane[4];

  unsigned bits() const {
    return unsigned{lane[0]} | unsigned{lane[1]} << 1 | unsigned{lane[2]} << 2 |
           unsigned{lane[3]} << 3;
  }
};

inline Mask4 less(const Lanes& a, const Lanes& b) {
  return {{a[0] < b[0], a[1] < b[1], a[2] < b[2], a[3] < b[3]}};
}
inline Mask4 less_equal(const Lanes& a, const Lanes& b) {
  return {{a[0] <= b[0], a[1] <= b[1], a[2] <= b[2], a[3] <= b[3]}};
}

template <typename Operation>
Mask4 each_yes(const Mask4& a, const Mask4& b, Operation operation) {
  return {{operation(a.lane[0], b.lane[0]), operation(a.lane[1], b.lane[1]),
           operation(a.lane[2], b.lane[2]), operation(a.lane[3], b.lane[3])}};
}

inline Mask4 operator&(const Mask4& a, const Mask4& b) {
  return each_yes(a, b, [](bool x, bool y) { return x && y; });
}
inline Mask4 operator|(const Mask4& a, const Mask4& b) {
  return each_yes(a, b, [](bool x, bool y) { return x || y; });
}
inline Mask4 operator^(const Mask4& a, const Mask4& b) {
  return each_yes(a, b, [](bool x, bool y) { return x != y; });
}
inline Lanes choose(const Mask4& mask, const Lanes& yes, const Lanes& no) {
  return {{mask.lane[0] ? yes[0] : no[0], mask.lane[1] ? yes[1] : no[1],
           mask.lane[2] ? yes[2] : no[2], mask.lane[3] ? yes[3] : no[3]}};
}

#else

using Lanes = float __attribute__((vector_size(16)));
using Yes = int __attribute__((vector_size(16)));

inline Lanes make_lanes(float x, float y, float z, float w) { return Lanes{x, y, z, w}; }
inline Lanes magnitude(Lanes a) { return Lanes(Yes(a) & 0x7FFFFFFF); }

#ifdef __SSE2__
// Compilers do not generate these two instructions themselves, because of NaN and signed zeros.
inline Lanes lower(Lanes a, Lanes b) { return _mm_min_ps(a, b); }
inline Lanes higher(Lanes a, Lanes b) { return _mm_max_ps(a, b); }
inline Lanes rotated(Lanes a) { return _mm_shuffle_ps(a, a, _MM_SHUFFLE(3, 0, 2, 1)); }
#else
inline Lanes lower(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes higher(Lanes a, Lanes b) { return b < a ? a : b; }
inline Lanes rotated(Lanes a) { return Lanes{a[1], a[2], a[0], a[3]}; }
#endif

struct Mask4 {
  Yes lanes;

  unsigned bits() const {
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_ps(Lanes(lanes)));
#elif defined(__wasm_simd128__)
    return wasm_i32x4_bitmask(lanes);
#else
    const Yes bit = lanes & Yes{1, 2, 4, 8};
    return static_cast<unsigned>(bit[0] | bit[1] | bit[2] | bit[3]);
#endif
  }
};

inline Mask4 less(Lanes a, Lanes b) { return {a < b}; }
inline Mask4 less_equal(Lanes a, Lanes b) { return {a <= b}; }
inline Mask4 operator&(Mask4 a, Mask4 b) { return {a.lanes & b.lanes}; }
inline Mask4 operator|(Mask4 a, Mask4 b) { return {a.lanes | b.lanes}; }
inline Mask4 operator^(Mask4 a, Mask4 b) { return {a.lanes ^ b.lanes}; }
inline Lanes choose(Mask4 mask, Lanes yes, Lanes no) {
  return Lanes((mask.lanes & Yes(yes)) | (~mask.lanes & Yes(no)));
}

#endif

struct Float4 {
  Lanes lanes;

  Float4() = default;
  explicit Float4(Lanes l) : lanes(l) {}
  explicit Float4(float s) : lanes(make_lanes(s, s, s, s)) {}
  Float4(float x, float y, float z, float w) : lanes(make_lanes(x, y, z, w)) {}

  float operator[](int i) const { return lanes[i]; }
};

inline Float4 operator+(const Float4& a, const Float4& b) { return Float4(a.lanes + b.lanes); }
inline Float4 operator-(const Float4& a, const Float4& b) { return Float4(a.lanes - b.lanes); }
inline Float4 operator*(const Float4& a, const Float4& b) { return Float4(a.lanes * b.lanes); }
inline Float4 operator/(const Float4& a, const Float4& b) { return Float4(a.lanes / b.lanes); }
inline Float4 operator*(float s, const Float4& v) { return Float4(s) * v; }
inline Float4 min(const Float4& a, const Float4& b) { return Float4(lower(a.lanes, b.lanes)); }
inline Float4 max(const Float4& a, const Float4& b) { return Float4(higher(a.lanes, b.lanes)); }
inline Float4 abs(const Float4& a) { return Float4(magnitude(a.lanes)); }

/// The lanes y, z, x and w.
inline Float4 rotated(const Float4& v) { return Float4(rotated(v.lanes)); }

/// Lane 3 is meaningless.
inline Float4 cross(const Float4& a, const Float4& b) {
  return rotated(a * rotated(b) - rotated(a) * b);
}

/// Bound of the magnitude of a cross product of vectors with these magnitudes.
inline Float4 cross_magnitude(const Float4& a, const Float4& b) {
  return rotated(a * rotated(b) + rotated(a) * b);
}

inline Float4 sqrt(const Float4& v) {
  return {std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}

inline Mask4 operator<(const Float4& a, const Float4& b) { return less(a.lanes, b.lanes); }
inline Mask4 operator<=(const Float4& a, const Float4& b) { return less_equal(a.lanes, b.lanes); }
inline Float4 select(const Mask4& mask, const Float4& yes, const Float4& no) {
  return Float4(choose(mask, yes.lanes, no.lanes));
}

/// Returns `yes` in lanes with x > 0, and `no` in the others, including NaN.
inline Float4 if_positive(const Float4& x, const Float4& yes, const Float4& no) {
  return select(Float4(0.0f) < x, yes, no);
}

/// Loads four floats with any alignment.
inline Float4 load4(const float* p) {
  Float4 v;
  std::memcpy(&v.lanes, p, sizeof v.lanes);
  return v;
}

/// Loads three floats with any alignment; the last lane is zero.
inline Float4 load3(const float* p) {
#if defined(__SSE2__) && !defined(PELT_SCALAR)
  double xy;
  std::memcpy(&xy, p, sizeof xy);
  return Float4(Lanes(_mm_movelh_ps(_mm_castpd_ps(_mm_set_sd(xy)), _mm_load_ss(p + 2))));
#else
  return {p[0], p[1], p[2], 0};
#endif
}

inline void store4(float* p, const Float4& v) { std::memcpy(p, &v.lanes, sizeof v.lanes); }

/// Transposes a 4 x 4 matrix.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
#if defined(__SSE2__) && !defined(PELT_SCALAR)
  const Lanes ab_xy = _mm_unpacklo_ps(a.lanes, b.lanes), ab_zw = _mm_unpackhi_ps(a.lanes, b.lanes);
  const Lanes cd_xy = _mm_unpacklo_ps(c.lanes, d.lanes), cd_zw = _mm_unpackhi_ps(c.lanes, d.lanes);
  a = Float4(_mm_movelh_ps(ab_xy, cd_xy)), b = Float4(_mm_movehl_ps(cd_xy, ab_xy));
  c = Float4(_mm_movelh_ps(ab_zw, cd_zw)), d = Float4(_mm_movehl_ps(cd_zw, ab_zw));
#else
  const Float4 x(a[0], b[0], c[0], d[0]), y(a[1], b[1], c[1], d[1]);
  const Float4 z(a[2], b[2], c[2], d[2]), w(a[3], b[3], c[3], d[3]);
  a = x, b = y, c = z, d = w;
#endif
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
