#pragma once

#include "query/scratch.hpp"

#include <pelt/contact.hpp>

namespace pelt::detail {

/// Chains the segments of `geometry` into curves. The links contain the ends of segments: `owner`
/// is twice the index of the trace, plus one for the end `to`. A curve ends where there is no link.
void chain_curves(ContactLinks& work, ContactGeometry& geometry);

}  // namespace pelt::detail
