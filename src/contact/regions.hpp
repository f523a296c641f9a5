#pragma once

#include "model/surface.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {

/// Groups the traces of `geometry` into regions.
void gather_regions(const Surface& a, const Surface& b, ContactLinks& work,
                    ContactGeometry& geometry);

}  // namespace pelt::detail
