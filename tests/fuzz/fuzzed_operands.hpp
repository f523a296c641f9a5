#pragma once

/// Makes the second operands of queries from bytes: rays, regions, solids, height fields.

#include "fuzz/fuzzed_bodies.hpp"

#include <pelt/height_field.hpp>
#include <pelt/solid.hpp>

#include <optional>

namespace pelt::test {

/// From a point near the body, to another one or in any direction.
Ray make_ray(FuzzBytes& bytes, const FuzzedBody& body);

/// One of any kind, with any finite numbers.
Region make_region(FuzzBytes& bytes, const FuzzedBody& body);

/// A solid as `distance` and `cast` require. The axes of oriented boxes are far from parallel.
Solid make_solid(FuzzBytes& bytes, const FuzzedBody& body);

/// Up to 13 x 13 vertices. Returns nothing if Pelt refuses the grid.
std::optional<HeightField> make_field(FuzzBytes& bytes);

}  // namespace pelt::test
