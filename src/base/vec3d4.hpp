#pragma once

/// Four vectors of doubles, processed in parallel with the operations of Vec3d.

#include "base/double4.hpp"

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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
