#pragma once

#include "model/surface.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {

/// Gathers the traces of `geometry` into patches.
void gather_patches(const Surface& a, const Surface& b, ContactLinks& work,
                    ContactGeometry& geometry);

}  // namespace pelt::detail
