#pragma once

#include "bindings/python/engine/pair_lists.hpp"

#include <cstdint>

namespace pelt::python {

/// Returns the hash that `pelt check` prints for these contacts: FNV-1a 64 over the little-endian
/// words frame, body_a, body_b, triangle_a and triangle_b of each contact.
std::uint64_t contact_hash(const Column& frames, const Column& triangles_a,
                           const Column& triangles_b, const Column& bodies_a,
                           const Column& bodies_b);

}  // namespace pelt::python
