#pragma once

/// Sixteen doubles processed in parallel, with the same bits on all machines.

#include "base/double4.hpp"

#include <cstddef>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

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
