#pragma once

#include <pelt/inside.hpp>

namespace pelt::detail {

/// Writes which body holds the other, as `pelt::containment` says.
QueryStats find_containment(pelt::Pose& a, const pelt::Surface& surface_a, pelt::Pose& b,
                            const pelt::Surface& surface_b, pelt::Scratch& scratch,
                            Containment& containment);

}  // namespace pelt::detail
