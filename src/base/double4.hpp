#pragma once

/// Four doubles worked on side by side: one register of four (AVX2), two of two, or plain doubles.
/// All do the same operations, so all give the same bits.

#include "base/float4.hpp"

#include <cstring>

#if defined(PELT_TARGET_AVX2)
#include <immintrin.h>
#endif

namespace pelt::detail {
inline namespace PELT_TARGET {

#if defined(PELT_TARGET_AVX2)
using DoubleShare = double __attribute__((vector_size(32)));
#elif defined(PELT_SCALAR)
using DoubleShare = double;
#else
using DoubleShare = double __attribute__((vector_size(16)));
#endif

inline constexpr int kDoubleShares = 4 * sizeof(double) / sizeof(DoubleShare);

struct Double4 {
  DoubleShare share[kDoubleShares];

  Double4() = default;
#if defined(PELT_TARGET_AVX2)
  explicit Double4(double s) : share{{s, s, s, s}} {}
  explicit Double4(const Float4& f) : share{__builtin_convertvector(f.lanes, DoubleShare)} {}
#elif defined(PELT_SCALAR)
  explicit Double4(double s) : share{s, s, s, s} {}
  explicit Double4(const Float4& f) : share{f[0], f[1], f[2], f[3]} {}
#else
  explicit Double4(double s) : share{{s, s}, {s, s}} {}
  explicit Double4(const Float4& f) : share{{f[0], f[1]}, {f[2], f[3]}} {}
#endif

  void store(double* p) const { std::memcpy(p, share, sizeof share); }
};

/// A yes or no for each lane.
struct MaskDouble4 {
  decltype(DoubleShare() < DoubleShare()) share[kDoubleShares];

  bool any() const {
#if defined(PELT_TARGET_AVX2)
    return _mm256_movemask_pd(DoubleShare(share[0])) != 0;
#elif defined(PELT_SCALAR)
    return share[0] || share[1] || share[2] || share[3];
#else
    const auto both = share[0] | share[1];
    return (both[0] | both[1]) != 0;
#endif
  }
};

template <typename Result, typename Operation>
[[gnu::always_inline]] inline Result each_share(const Operation& operation) {
  Result result;
  for (int i = 0; i < kDoubleShares; ++i) result.share[i] = operation(i);
  return result;
}

inline Double4 operator+(const Double4& a, const Double4& b) {
  return each_share<Double4>([&](int i) { return a.share[i] + b.share[i]; });
}
inline Double4 operator-(const Double4& a, const Double4& b) {
  return each_share<Double4>([&](int i) { return a.share[i] - b.share[i]; });
}
inline Double4 operator-(const Double4& a) {
  return each_share<Double4>([&](int i) { return -a.share[i]; });
}
inline Double4 operator*(const Double4& a, const Double4& b) {
  return each_share<Double4>([&](int i) { return a.share[i] * b.share[i]; });
}
inline Double4 operator/(const Double4& a, const Double4& b) {
  return each_share<Double4>([&](int i) { return a.share[i] / b.share[i]; });
}
inline MaskDouble4 operator<(const Double4& a, const Double4& b) {
  return each_share<MaskDouble4>([&](int i) { return a.share[i] < b.share[i]; });
}
inline MaskDouble4 operator&(const MaskDouble4& a, const MaskDouble4& b) {
  return each_share<MaskDouble4>([&](int i) { return a.share[i] & b.share[i]; });
}
inline Double4 select(const MaskDouble4& mask, const Double4& yes, const Double4& no) {
  return each_share<Double4>([&](int i) { return mask.share[i] ? yes.share[i] : no.share[i]; });
}

/// Where a lane of both is not a number: the second's.
inline Double4 min(const Double4& a, const Double4& b) { return select(a < b, a, b); }
inline Double4 max(const Double4& a, const Double4& b) { return select(b < a, a, b); }

}  // namespace PELT_TARGET
}  // namespace pelt::detail
