#pragma once

#include <pelt/distance.hpp>

#include "distance/pair_search.hpp"

namespace pelt::detail {

SurfacePoint surface_point(std::uint32_t triangle, const TriangleCorners& corners,
                           const Barycentrics& at);

/// Returns the answer for two triangles that touch, without a location.
Distance distance_touching(const Contact& contact, const TriangleCorners& corners_a,
                           const TriangleCorners& corners_b);

/// Returns the answer for operands that do not touch, from a search within the options' limits.
Distance distance_apart(const TriangleGap& gap, const DistanceOptions& options);

}  // namespace pelt::detail
