#pragma once

#include <pelt/inside.hpp>

namespace pelt::detail {

/// Writes which body contains the other, as defined by `pelt::containment`.
QueryStats find_containment(pelt::Pose& a, const pelt::Surface& surface_a, pelt::Pose& b,
                            const pelt::Surface& surface_b, pelt::Scratch& scratch,
                            Containment& containment);

}  // namespace pelt::detail
