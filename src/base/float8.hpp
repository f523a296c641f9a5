#pragma once

/// Eight floats processed in parallel, in three implementations of the same operations: one
/// register of eight (AVX2), two of four, or plain floats. None of them fuses a multiplication with
/// an addition, so all give the same bits.

#include "base/float4.hpp"
#include "base/instruction_set.hpp"

#if defined(PELT_INSTRUCTION_SET_AVX2)
#include <immintrin.h>
#endif

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

#if defined(PELT_INSTRUCTION_SET_AVX2)

struct Float8 {
  __m256 lanes;

  Float8() = default;
  explicit Float8(__m256 l) : lanes(l) {}
  explicit Float8(float s) : lanes(_mm256_set1_ps(s)) {}
  Float8(const Float4& low, const Float4& high) : lanes(_mm256_set_m128(high.lanes, low.lanes)) {}

  Float4 low() const { return Float4(_mm256_castps256_ps128(lanes)); }
  Float4 high() const { return Float4(_mm256_extractf128_ps(lanes, 1)); }
  void store(float* p) const { _mm256_storeu_ps(p, lanes); }
};

/// A boolean for each lane.
struct Mask8 {
  __m256 lanes;

  unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_ps(lanes)); }
};

inline Float8 load8(const float* p) { return Float8(_mm256_loadu_ps(p)); }

inline Float8 operator+(Float8 a, Float8 b) { return Float8(_mm256_add_ps(a.lanes, b.lanes)); }
inline Float8 operator-(Float8 a, Float8 b) { return Float8(_mm256_sub_ps(a.lanes, b.lanes)); }
inline Float8 operator*(Float8 a, Float8 b) { return Float8(_mm256_mul_ps(a.lanes, b.lanes)); }
inline Float8 operator/(Float8 a, Float8 b) { return Float8(_mm256_div_ps(a.lanes, b.lanes)); }
inline Float8 sqrt(Float8 a) { return Float8(_mm256_sqrt_ps(a.lanes)); }
inline Float8 min(Float8 a, Float8 b) { return Float8(_mm256_min_ps(a.lanes, b.lanes)); }
inline Float8 max(Float8 a, Float8 b) { return Float8(_mm256_max_ps(a.lanes, b.lanes)); }
inline Float8 abs(Float8 a) { return Float8(_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.lanes)); }
inline Mask8 operator<=(Float8 a, Float8 b) {
  return {_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LE_OQ)};
}
inline Mask8 operator<(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LT_OQ)}; }
inline Mask8 operator&(Mask8 a, Mask8 b) { return {_mm256_and_ps(a.lanes, b.lanes)}; }
inline Mask8 operator|(Mask8 a, Mask8 b) { return {_mm256_or_ps(a.lanes, b.lanes)}; }
inline Mask8 operator^(Mask8 a, Mask8 b) { return {_mm256_xor_ps(a.lanes, b.lanes)}; }
inline Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  return Float8(_mm256_blendv_ps(no.lanes, yes.lanes, mask.lanes));
}

#else

/// Two Float4; in a scalar build each of them is four plain floats.
struct Float8 {
  Float4 four[2];

  Float8() = default;
  explicit Float8(float s) : four{Float4(s), Float4(s)} {}
  Float8(const Float4& low, const Float4& high) : four{low, high} {}

  Float4 low() const { return four[0]; }
  Float4 high() const { return four[1]; }
  void store(float* p) const { store4(p, four[0]), store4(p + 4, four[1]); }
};

struct Mask8 {
  Mask4 four[2];

  unsigned bits() const { return four[0].bits() | four[1].bits() << 4; }
};

inline Float8 load8(const float* p) { return {load4(p), load4(p + 4)}; }

inline Float8 operator+(const Float8& a, const Float8& b) {
  return {a.four[0] + b.four[0], a.four[1] + b.four[1]};
}
inline Float8 operator-(const Float8& a, const Float8& b) {
  return {a.four[0] - b.four[0], a.four[1] - b.four[1]};
}
inline Float8 operator*(const Float8& a, const Float8& b) {
  return {a.four[0] * b.four[0], a.four[1] * b.four[1]};
}
inline Float8 operator/(const Float8& a, const Float8& b) {
  return {a.four[0] / b.four[0], a.four[1] / b.four[1]};
}
inline Float8 sqrt(const Float8& a) { return {sqrt(a.four[0]), sqrt(a.four[1])}; }
inline Float8 min(const Float8& a, const Float8& b) {
  return {min(a.four[0], b.four[0]), min(a.four[1], b.four[1])};
}
inline Float8 max(const Float8& a, const Float8& b) {
  return {max(a.four[0], b.four[0]), max(a.four[1], b.four[1])};
}
inline Float8 abs(const Float8& a) { return {abs(a.four[0]), abs(a.four[1])}; }
inline Mask8 operator<=(const Float8& a, const Float8& b) {
  return {{a.four[0] <= b.four[0], a.four[1] <= b.four[1]}};
}
inline Mask8 operator<(const Float8& a, const Float8& b) {
  return {{a.four[0] < b.four[0], a.four[1] < b.four[1]}};
}
inline Mask8 operator&(const Mask8& a, const Mask8& b) {
  return {{a.four[0] & b.four[0], a.four[1] & b.four[1]}};
}
inline Mask8 operator|(const Mask8& a, const Mask8& b) {
  return {{a.four[0] | b.four[0], a.four[1] | b.four[1]}};
}
inline Mask8 operator^(const Mask8& a, const Mask8& b) {
  return {{a.four[0] ^ b.four[0], a.four[1] ^ b.four[1]}};
}
inline Float8 select(const Mask8& mask, const Float8& yes, const Float8& no) {
  return {select(mask.four[0], yes.four[0], no.four[0]),
          select(mask.four[1], yes.four[1], no.four[1])};
}

#endif

/// Returns one lane. Goes through memory.
inline float lane_of(const Float8& v, unsigned lane) {
  float lanes[8];
  v.store(lanes);
  return lanes[lane];
}

/// [a a a a b b b b], factors for two adjacent columns of a matrix.
inline Float8 pair8(float a, float b) { return {Float4(a), Float4(b)}; }

/// Four floats as factors of a matrix's columns: [x x x x y y y y] and [z z z z w w w w].
struct ColumnFactors {
  Float8 xy, zw;
};

inline ColumnFactors column_factors(const float* v) {
#if defined(PELT_INSTRUCTION_SET_AVX2)
  const __m256 twice = Float8(load4(v), load4(v)).lanes;
  return {Float8(_mm256_permutevar_ps(twice, _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1))),
          Float8(_mm256_permutevar_ps(twice, _mm256_setr_epi32(2, 2, 2, 2, 3, 3, 3, 3)))};
#else
  return {pair8(v[0], v[1]), pair8(v[2], v[3])};
#endif
}

/// Returns the sum of both halves.
inline Float4 fold(const Float8& v) { return v.low() + v.high(); }

/// Eight points in structure-of-arrays order: lane i of `x` belongs to point i.
struct Points8 {
  Float8 x, y, z;
};

inline Points8 transpose8(const Float4& p0, const Float4& p1, const Float4& p2, const Float4& p3,
                          const Float4& p4, const Float4& p5, const Float4& p6, const Float4& p7) {
#if defined(PELT_INSTRUCTION_SET_AVX2)
  const __m256 a = Float8(p0, p4).lanes, b = Float8(p1, p5).lanes;
  const __m256 c = Float8(p2, p6).lanes, d = Float8(p3, p7).lanes;
  const __m256 ab_xy = _mm256_unpacklo_ps(a, b), cd_xy = _mm256_unpacklo_ps(c, d);
  const __m256 ab_z = _mm256_unpackhi_ps(a, b), cd_z = _mm256_unpackhi_ps(c, d);
  return {Float8(_mm256_shuffle_ps(ab_xy, cd_xy, 0x44)),
          Float8(_mm256_shuffle_ps(ab_xy, cd_xy, 0xEE)),
          Float8(_mm256_shuffle_ps(ab_z, cd_z, 0x44))};
#else
  Float4 a = p0, b = p1, c = p2, d = p3, e = p4, f = p5, g = p6, h = p7;
  transpose(a, b, c, d);
  transpose(e, f, g, h);
  return {{a, e}, {b, f}, {c, g}};
#endif
}

/// Eight vectors of four floats in structure-of-arrays order.
struct Rows8 {
  Float8 x, y, z, w;
};

/// Like `transpose8`, with the fourth lanes.
inline Rows8 rows8(const Float4& p0, const Float4& p1, const Float4& p2, const Float4& p3,
                   const Float4& p4, const Float4& p5, const Float4& p6, const Float4& p7) {
#if defined(PELT_INSTRUCTION_SET_AVX2)
  const __m256 a = Float8(p0, p4).lanes, b = Float8(p1, p5).lanes;
  const __m256 c = Float8(p2, p6).lanes, d = Float8(p3, p7).lanes;
  const __m256 ab_xy = _mm256_unpacklo_ps(a, b), cd_xy = _mm256_unpacklo_ps(c, d);
  const __m256 ab_zw = _mm256_unpackhi_ps(a, b), cd_zw = _mm256_unpackhi_ps(c, d);
  return {
      Float8(_mm256_shuffle_ps(ab_xy, cd_xy, 0x44)), Float8(_mm256_shuffle_ps(ab_xy, cd_xy, 0xEE)),
      Float8(_mm256_shuffle_ps(ab_zw, cd_zw, 0x44)), Float8(_mm256_shuffle_ps(ab_zw, cd_zw, 0xEE))};
#else
  Float4 a = p0, b = p1, c = p2, d = p3, e = p4, f = p5, g = p6, h = p7;
  transpose(a, b, c, d);
  transpose(e, f, g, h);
  return {{a, e}, {b, f}, {c, g}, {d, h}};
#endif
}

/// Writes the vectors one by one, the inverse of `rows8`.
inline void vectors_of(const Rows8& rows, Float4 (&vectors)[8]) {
#if defined(PELT_INSTRUCTION_SET_AVX2)
  const __m256 xy_low = _mm256_unpacklo_ps(rows.x.lanes, rows.y.lanes);
  const __m256 xy_high = _mm256_unpackhi_ps(rows.x.lanes, rows.y.lanes);
  const __m256 zw_low = _mm256_unpacklo_ps(rows.z.lanes, rows.w.lanes);
  const __m256 zw_high = _mm256_unpackhi_ps(rows.z.lanes, rows.w.lanes);
  const Float8 twice[] = {Float8(_mm256_shuffle_ps(xy_low, zw_low, 0x44)),
                          Float8(_mm256_shuffle_ps(xy_low, zw_low, 0xEE)),
                          Float8(_mm256_shuffle_ps(xy_high, zw_high, 0x44)),
                          Float8(_mm256_shuffle_ps(xy_high, zw_high, 0xEE))};
  for (int i = 0; i < 4; ++i) vectors[i] = twice[i].low(), vectors[4 + i] = twice[i].high();
#else
  for (int half = 0; half < 2; ++half) {
    const auto part = [half](const Float8& v) { return half == 0 ? v.low() : v.high(); };
    Float4 a = part(rows.x), b = part(rows.y), c = part(rows.z), d = part(rows.w);
    transpose(a, b, c, d);
    Float4* const to = half == 0 ? vectors : vectors + 4;
    to[0] = a, to[1] = b, to[2] = c, to[3] = d;
  }
#endif
}

/// The same for points. Fourth lanes are meaningless.
inline void points_of(const Points8& p, Float4 (&points)[8]) {
  vectors_of({p.x, p.y, p.z, p.z}, points);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
