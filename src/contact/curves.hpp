#pragma once

#include <pelt/surface.hpp>

#include "contact/traces.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {

/// Chains the segments of `geometry` into curves. The links contain the ends of segments: `owner`
/// is twice the index of the trace, plus one for the end `to`. A curve ends where there is no link.
void chain_curves(ContactLinks& work, ContactGeometry& geometry);

/// Gathers the traces of `geometry` into patches.
void gather_patches(const ContactSurfaces& surfaces, ContactLinks& work, ContactGeometry& geometry);

}  // namespace pelt::detail
