#pragma once

/// Four floats worked on side by side: the one place with vector instructions. The scalar twin
/// (PELT_SCALAR) does the same operations in the same order, so both give the same bits.

#include <cmath>
#include <cstring>

namespace pelt::detail {

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
inline Lanes lower(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Lanes higher(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
  return each_lane(a, b, [](float x, float y) { return x / y; });
}
inline Lanes if_positive(const Lanes& x, const Lanes& yes, const Lanes& no) {
  return {{x[0] > 0 ? yes[0] : no[0], x[1] > 0 ? yes[1] : no[1], x[2] > 0 ? yes[2] : no[2],
           x[3] > 0 ? yes[3] : no[3]}};
}
inline Lanes make_lanes(float x, float y, float z, float w) { return {{x, y, z, w}}; }

#else

using Lanes = float __attribute__((vector_size(16)));

inline Lanes lower(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes higher(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes if_positive(Lanes x, Lanes yes, Lanes no) { return x > 0 ? yes : no; }
inline Lanes make_lanes(float x, float y, float z, float w) { return Lanes{x, y, z, w}; }

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
inline Float4 operator*(float s, const Float4& v) { return Float4(s) * v; }
inline Float4 min(const Float4& a, const Float4& b) { return Float4(lower(a.lanes, b.lanes)); }
inline Float4 max(const Float4& a, const Float4& b) { return Float4(higher(a.lanes, b.lanes)); }

inline Float4 operator/(const Float4& a, const Float4& b) { return Float4(a.lanes / b.lanes); }
inline Float4 sqrt(const Float4& v) {
  return {std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}

/// In each lane `yes` where x > 0, otherwise (NaN too) `no`.
inline Float4 if_positive(const Float4& x, const Float4& yes, const Float4& no) {
  return Float4(if_positive(x.lanes, yes.lanes, no.lanes));
}

/// Any four floats, aligned or not.
inline Float4 load4(const float* p) {
  Float4 v;
  std::memcpy(&v.lanes, p, sizeof v.lanes);
  return v;
}

/// Rows to columns.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  const Float4 x(a[0], b[0], c[0], d[0]), y(a[1], b[1], c[1], d[1]);
  const Float4 z(a[2], b[2], c[2], d[2]), w(a[3], b[3], c[3], d[3]);
  a = x, b = y, c = z, d = w;
}

}  // namespace pelt::detail
