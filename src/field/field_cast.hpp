#pragma once

#include <pelt/ray.hpp>

#include "field/height_field.hpp"

namespace pelt::detail {

/// What a ray hits first of a field. Precondition: its numbers are finite, but for its ends.
RayHit cast_at_field(const HeightField& field, const Ray& ray, Facing facing, QueryStats& work);

}  // namespace pelt::detail
