#pragma once

#include <pelt/ray.hpp>

#include "field/height_field.hpp"

namespace pelt::detail {

/// Finds the first hit of a ray on a field. Precondition: all numbers of the ray except its ends
/// are finite.
RayHit cast_at_field(const HeightField& field, const Ray& ray, Facing facing, QueryStats& work);

}  // namespace pelt::detail
