#pragma once

/// Four doubles processed in parallel: one register of four (AVX2), two of two, or plain doubles.
/// All perform the same operations and give the same bits. Then four vectors of doubles, with the
/// operations of Vec3d, and sixteen doubles.

#include "base/float4.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(PELT_INSTRUCTION_SET_AVX2)
#include <immintrin.h>
#endif

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Two named halves: compilers keep them in registers, whereas they keep arrays in memory.
template <typename Half>
struct TwoHalves {
  Half low, high;
};

template <typename Half>
TwoHalves<Half> operator+(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return {a.low + b.low, a.high + b.high};
}
template <typename Half>
TwoHalves<Half> operator-(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return {a.low - b.low, a.high - b.high};
}
template <typename Half>
TwoHalves<Half> operator-(const TwoHalves<Half>& a) {
  return {-a.low, -a.high};
}
template <typename Half>
TwoHalves<Half> operator*(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return {a.low * b.low, a.high * b.high};
}
template <typename Half>
TwoHalves<Half> operator/(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return {a.low / b.low, a.high / b.high};
}
template <typename Half>
auto operator<(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return TwoHalves<decltype(a.low < b.low)>{a.low < b.low, a.high < b.high};
}

inline bool both(bool a, bool b) { return a && b; }
inline bool is_any(bool yes) { return yes; }
inline unsigned bits_of(bool yes) { return yes; }
inline double choose(bool mask, double yes, double no) { return mask ? yes : no; }
inline double square_root(double a) { return std::sqrt(a); }

#if defined(PELT_INSTRUCTION_SET_AVX2)
using DoubleLanes = double __attribute__((vector_size(32)));
using DoubleYes = decltype(DoubleLanes() < DoubleLanes());

inline DoubleLanes double_lanes(double x, double y, double z, double w) {
  return DoubleLanes{x, y, z, w};
}
inline DoubleLanes widened(Lanes f) { return _mm256_cvtps_pd(f); }
inline Lanes narrowed(DoubleLanes d) { return _mm256_cvtpd_ps(d); }
inline DoubleLanes square_root(DoubleLanes a) { return _mm256_sqrt_pd(a); }
inline DoubleYes both(DoubleYes a, DoubleYes b) { return a & b; }
inline unsigned bits_of(DoubleYes yes) {
  return static_cast<unsigned>(_mm256_movemask_pd(DoubleLanes(yes)));
}
inline bool is_any(DoubleYes yes) { return bits_of(yes) != 0; }
inline DoubleLanes choose(DoubleYes mask, DoubleLanes yes, DoubleLanes no) {
  return mask ? yes : no;
}
#else
#if defined(PELT_SCALAR)
using DoublePair = TwoHalves<double>;
#else
using DoublePair = double __attribute__((vector_size(16)));
using DoubleYes = decltype(DoublePair() < DoublePair());

inline DoubleYes both(DoubleYes a, DoubleYes b) { return a & b; }
inline bool is_any(DoubleYes yes) { return (yes[0] | yes[1]) != 0; }
#ifdef __SSE2__
inline unsigned bits_of(DoubleYes yes) {
  return static_cast<unsigned>(_mm_movemask_pd(DoublePair(yes)));
}
#else
inline unsigned bits_of(DoubleYes yes) {
  return static_cast<unsigned>((yes[0] & 1) | (yes[1] & 2));
}
#endif
inline DoublePair choose(DoubleYes mask, DoublePair yes, DoublePair no) {
  return DoublePair((mask & DoubleYes(yes)) | (~mask & DoubleYes(no)));
}
inline DoublePair square_root(DoublePair a) { return DoublePair{std::sqrt(a[0]), std::sqrt(a[1])}; }
#endif
using DoubleLanes = TwoHalves<DoublePair>;

inline DoubleLanes double_lanes(double x, double y, double z, double w) {
  return {DoublePair{x, y}, DoublePair{z, w}};
}
inline DoubleLanes widened(const Lanes& f) { return double_lanes(f[0], f[1], f[2], f[3]); }
inline Lanes narrowed(const DoubleLanes& d) {
  double lanes[4];
  std::memcpy(lanes, &d, sizeof lanes);
  return make_lanes(static_cast<float>(lanes[0]), static_cast<float>(lanes[1]),
                    static_cast<float>(lanes[2]), static_cast<float>(lanes[3]));
}
#endif

template <typename Half>
TwoHalves<Half> both(const TwoHalves<Half>& a, const TwoHalves<Half>& b) {
  return {both(a.low, b.low), both(a.high, b.high)};
}
template <typename Half>
bool is_any(const TwoHalves<Half>& yes) {
  return is_any(yes.low) || is_any(yes.high);
}
template <typename Half>
unsigned bits_of(const TwoHalves<Half>& yes) {
  constexpr unsigned kLanesOfHalf = sizeof(Half) == sizeof(bool) ? 1 : 2;
  return bits_of(yes.low) | bits_of(yes.high) << kLanesOfHalf;
}
template <typename Half>
TwoHalves<Half> square_root(const TwoHalves<Half>& a) {
  return {square_root(a.low), square_root(a.high)};
}
template <typename Yes, typename Half>
TwoHalves<Half> choose(const TwoHalves<Yes>& mask, const TwoHalves<Half>& yes,
                       const TwoHalves<Half>& no) {
  return {choose(mask.low, yes.low, no.low), choose(mask.high, yes.high, no.high)};
}

struct Double4 {
  DoubleLanes lanes;

  Double4() = default;
  explicit Double4(const DoubleLanes& l) : lanes(l) {}
  explicit Double4(double s) : lanes(double_lanes(s, s, s, s)) {}
  explicit Double4(const Float4& f) : lanes(widened(f.lanes)) {}

  void store(double* p) const { std::memcpy(p, &lanes, sizeof lanes); }

  Float4 rounded() const { return Float4(narrowed(lanes)); }
};

/// A boolean for each lane.
struct MaskDouble4 {
  decltype(DoubleLanes() < DoubleLanes()) lanes;

  bool any() const { return is_any(lanes); }
  unsigned bits() const { return bits_of(lanes); }
};

inline Double4 operator+(const Double4& a, const Double4& b) { return Double4(a.lanes + b.lanes); }
inline Double4 operator-(const Double4& a, const Double4& b) { return Double4(a.lanes - b.lanes); }
inline Double4 operator-(const Double4& a) { return Double4(-a.lanes); }
inline Double4 operator*(const Double4& a, const Double4& b) { return Double4(a.lanes * b.lanes); }
inline Double4 operator/(const Double4& a, const Double4& b) { return Double4(a.lanes / b.lanes); }
inline Double4 sqrt(const Double4& a) { return Double4(square_root(a.lanes)); }
inline MaskDouble4 operator<(const Double4& a, const Double4& b) { return {a.lanes < b.lanes}; }
inline MaskDouble4 operator&(const MaskDouble4& a, const MaskDouble4& b) {
  return {both(a.lanes, b.lanes)};
}
inline Double4 select(const MaskDouble4& mask, const Double4& yes, const Double4& no) {
  return Double4(choose(mask.lanes, yes.lanes, no.lanes));
}

/// If a lane of either argument is NaN, returns the lane of the second.
inline Double4 min(const Double4& a, const Double4& b) { return select(a < b, a, b); }
inline Double4 max(const Double4& a, const Double4& b) { return select(b < a, a, b); }

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

struct Vec3d4 {
  Double4 x, y, z;
};

inline Vec3d4 operator+(const Vec3d4& a, const Vec3d4& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3d4 operator-(const Vec3d4& a, const Vec3d4& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3d4 operator*(const Double4& s, const Vec3d4& v) { return {s * v.x, s * v.y, s * v.z}; }

inline Double4 dot(const Vec3d4& a, const Vec3d4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Double4 squared_length(const Vec3d4& v) { return dot(v, v); }

inline Vec3d4 cross(const Vec3d4& a, const Vec3d4& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Double16 {
  Double4 quarters[4];

  Double16() = default;
  explicit Double16(double s) : quarters{Double4(s), Double4(s), Double4(s), Double4(s)} {}
  explicit Double16(const double (&s)[16])
      : quarters{four(s[0], s[1], s[2], s[3]), four(s[4], s[5], s[6], s[7]),
                 four(s[8], s[9], s[10], s[11]), four(s[12], s[13], s[14], s[15])} {}

  double operator[](std::size_t lane) const {
    double value;
    std::memcpy(&value, reinterpret_cast<const char*>(quarters) + lane * sizeof value,
                sizeof value);
    return value;
  }

 private:
  static Double4 four(double x, double y, double z, double w) {
    return Double4(double_lanes(x, y, z, w));
  }
};

template <typename Operation>
Double16 each_quarter(const Double16& a, const Double16& b, const Operation& operation) {
  Double16 result;
  for (std::size_t i = 0; i < 4; ++i) result.quarters[i] = operation(a.quarters[i], b.quarters[i]);
  return result;
}

inline Double16 operator+(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return x + y; });
}
inline Double16 operator-(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return x - y; });
}
inline Double16 operator*(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return x * y; });
}
inline Double16 operator/(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return x / y; });
}
inline Double16 operator*(double s, const Double16& a) { return Double16(s) * a; }
inline Double16 operator-(const Double16& a) { return Double16(0.0) - a; }

/// If a lane of either argument is NaN, returns the lane of the second.
inline Double16 min(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return min(x, y); });
}
inline Double16 max(const Double16& a, const Double16& b) {
  return each_quarter(a, b, [](const Double4& x, const Double4& y) { return max(x, y); });
}
inline Double16 abs(const Double16& a) { return max(a, -a); }

/// The lanes in which a < b, as bits.
inline unsigned less(const Double16& a, const Double16& b) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= (a.quarters[i] < b.quarters[i]).bits() << 4 * i;
  return bits;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
