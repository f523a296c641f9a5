#pragma once

/// Arithmetic on eight points or vectors side by side.

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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
