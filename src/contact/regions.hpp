#pragma once

#include "model/surface.hpp"

namespace pelt::detail {

/// Gathers the traces of `geometry` to regions.
void gather_regions(const Surface& a, const Surface& b, ContactGeometry& geometry);

}  // namespace pelt::detail
