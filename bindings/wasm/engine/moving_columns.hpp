#pragma once

/// What JavaScript reads about moving contacts beside their triangles, one array after the other.

#include <pelt/motion.hpp>

#include <cstdint>

namespace pelt::wasm {

/// Removes the contacts of the query before.
void clear_moving_columns();

/// Adds times and features, with zeros for what has no meaning. JavaScript reads them with
/// pelt_moving_column until the next query of motions.
void add_to_moving_columns(const MovingContact& moving);

}  // namespace pelt::wasm
