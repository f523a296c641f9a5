#pragma once

#include "contact/end_key.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {

/// Gathers the traces of `geometry` into patches.
void gather_patches(const ContactSurfaces& surfaces, ContactLinks& work, ContactGeometry& geometry);

}  // namespace pelt::detail
