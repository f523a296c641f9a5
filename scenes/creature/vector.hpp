#pragma once

#include "base/vec3.hpp"

#include <cmath>

namespace pelt::scenes {

using detail::cross;
using detail::dot;
using detail::squared_length;
using detail::Vec3d;

inline double length(const Vec3d& v) { return std::sqrt(squared_length(v)); }

/// Precondition: `v` is not 0.
inline Vec3d unit(const Vec3d& v) { return (1 / length(v)) * v; }

inline Vec3d mix(const Vec3d& a, const Vec3d& b, double t) { return a + t * (b - a); }

}  // namespace pelt::scenes
