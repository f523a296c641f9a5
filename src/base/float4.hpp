#pragma once

/// Four floats worked on side by side: the one place with vector instructions. The scalar twin
/// (PELT_SCALAR) does the same operations in the same order, so both give the same bits.

#include <cstring>

namespace pelt::detail {

#ifdef PELT_SCALAR

struct Float4 {
  float lane[4];

  float operator[](int i) const { return lane[i]; }
};

inline Float4 operator+(const Float4& a, const Float4& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}};
}
inline Float4 operator-(const Float4& a, const Float4& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
}
inline Float4 operator*(const Float4& a, const Float4& b) {
  return {{a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]}};
}
inline Float4 broadcast(float s) { return {{s, s, s, s}}; }

#else

using Float4 = float __attribute__((vector_size(16)));

inline Float4 broadcast(float s) { return Float4{s, s, s, s}; }

#endif

inline Float4 operator*(float s, const Float4& v) { return broadcast(s) * v; }

/// Any four floats, aligned or not.
inline Float4 load4(const float* p) {
  Float4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

}  // namespace pelt::detail
