#pragma once

/// Sixteen 16-bit integers processed in parallel: one register of sixteen (AVX2), two of eight, or
/// plain integers.

#include "base/float8.hpp"
#include "base/instruction_set.hpp"

#include <algorithm>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

#if defined(PELT_INSTRUCTION_SET_AVX2)

struct Short16 {
  __m256i lanes;

  Short16() = default;
  explicit Short16(__m256i l) : lanes(l) {}
  explicit Short16(std::int16_t s) : lanes(_mm256_set1_epi16(s)) {}

  void store(std::int16_t* p) const { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), lanes); }
};

/// A boolean for each lane.
struct Mask16 {
  __m256i lanes;

  unsigned bits() const {
    const __m128i low = _mm256_castsi256_si128(lanes), high = _mm256_extracti128_si256(lanes, 1);
    return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
  }
};

inline Short16 load16(const std::int16_t* p) {
  return Short16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)));
}

inline Mask16 operator>(Short16 a, Short16 b) { return {_mm256_cmpgt_epi16(a.lanes, b.lanes)}; }
inline Mask16 operator==(Short16 a, Short16 b) { return {_mm256_cmpeq_epi16(a.lanes, b.lanes)}; }
inline Short16 operator&(Short16 a, Short16 b) {
  return Short16(_mm256_and_si256(a.lanes, b.lanes));
}
inline Mask16 operator|(Mask16 a, Mask16 b) { return {_mm256_or_si256(a.lanes, b.lanes)}; }

/// Rounds towards zero. Precondition: all floats are in [-32768, 32767].
inline Short16 truncate(Float8 low, Float8 high) {
  const __m256i words =
      _mm256_packs_epi32(_mm256_cvttps_epi32(low.lanes), _mm256_cvttps_epi32(high.lanes));
  return Short16(_mm256_permute4x64_epi64(words, 0b11'01'10'00));
}

#elif !defined(PELT_SCALAR) && (defined(__SSE2__) || defined(__wasm_simd128__))

using Shorts8 = std::int16_t __attribute__((vector_size(16)));

/// Two registers of eight.
struct Short16 {
  Shorts8 eight[2];

  Short16() = default;
  Short16(Shorts8 low, Shorts8 high) : eight{low, high} {}
  explicit Short16(std::int16_t s) : eight{Shorts8{} + s, Shorts8{} + s} {}

  void store(std::int16_t* p) const { std::memcpy(p, eight, sizeof eight); }
};

struct Mask16 {
  Shorts8 eight[2];

  unsigned bits() const {
#ifdef __SSE2__
    return static_cast<unsigned>(
        _mm_movemask_epi8(_mm_packs_epi16(__m128i(eight[0]), __m128i(eight[1]))));
#else
    return wasm_i16x8_bitmask(v128_t(eight[0])) | wasm_i16x8_bitmask(v128_t(eight[1])) << 8;
#endif
  }
};

inline Short16 load16(const std::int16_t* p) {
  Short16 s;
  std::memcpy(s.eight, p, sizeof s.eight);
  return s;
}

inline Mask16 operator>(const Short16& a, const Short16& b) {
  return {{a.eight[0] > b.eight[0], a.eight[1] > b.eight[1]}};
}
inline Mask16 operator==(const Short16& a, const Short16& b) {
  return {{a.eight[0] == b.eight[0], a.eight[1] == b.eight[1]}};
}
inline Short16 operator&(const Short16& a, const Short16& b) {
  return {a.eight[0] & b.eight[0], a.eight[1] & b.eight[1]};
}
inline Mask16 operator|(const Mask16& a, const Mask16& b) {
  return {{a.eight[0] | b.eight[0], a.eight[1] | b.eight[1]}};
}

inline Shorts8 truncate(const Float8& v) {
  const Yes low = __builtin_convertvector(v.four[0].lanes, Yes);
  const Yes high = __builtin_convertvector(v.four[1].lanes, Yes);
#ifdef __SSE2__
  return Shorts8(_mm_packs_epi32(__m128i(low), __m128i(high)));
#else
  return Shorts8(wasm_i16x8_narrow_i32x4(low, high));
#endif
}

inline Short16 truncate(const Float8& low, const Float8& high) {
  return {truncate(low), truncate(high)};
}

#else

struct Short16 {
  std::int16_t lane[16];

  Short16() = default;
  explicit Short16(std::int16_t s) { std::fill_n(lane, 16, s); }

  void store(std::int16_t* p) const { std::memcpy(p, lane, sizeof lane); }
};

struct Mask16 {
  unsigned lanes;  // one bit per lane

  unsigned bits() const { return lanes; }
};

inline Short16 load16(const std::int16_t* p) {
  Short16 s;
  std::memcpy(s.lane, p, sizeof s.lane);
  return s;
}

inline Mask16 operator>(const Short16& a, const Short16& b) {
  unsigned bits = 0;
  for (unsigned i = 0; i < 16; ++i) bits |= unsigned{a.lane[i] > b.lane[i]} << i;
  return {bits};
}
inline Mask16 operator==(const Short16& a, const Short16& b) {
  unsigned bits = 0;
  for (unsigned i = 0; i < 16; ++i) bits |= unsigned{a.lane[i] == b.lane[i]} << i;
  return {bits};
}
inline Short16 operator&(const Short16& a, const Short16& b) {
  Short16 both;
  for (int i = 0; i < 16; ++i) both.lane[i] = static_cast<std::int16_t>(a.lane[i] & b.lane[i]);
  return both;
}
inline Mask16 operator|(Mask16 a, Mask16 b) { return {a.lanes | b.lanes}; }

inline Short16 truncate(const Float8& low, const Float8& high) {
  float floats[16];
  low.store(floats), high.store(floats + 8);
  Short16 s;
  for (int i = 0; i < 16; ++i) s.lane[i] = static_cast<std::int16_t>(floats[i]);
  return s;
}

#endif

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
