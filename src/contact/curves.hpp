#pragma once

#include "geometry/triangle_crossing.hpp"
#include "model/surface.hpp"
#include "query/scratch.hpp"

#include <span>

namespace pelt::detail {

/// Returns a key of an end of a trace, made from the features that meet there. Equal for all
/// triangles that share these features.
std::array<std::uint32_t, 6> key_of(const CrossingEnd& end, const Contact& contact,
                                    const Surface& a, const Surface& b);

/// Chains the segments of `geometry` into curves. The links contain the ends of all segments:
/// `owner` is twice the index of the trace, plus one for the end `to`.
void chain_curves(ContactLinks& work, ContactGeometry& geometry);

}  // namespace pelt::detail
