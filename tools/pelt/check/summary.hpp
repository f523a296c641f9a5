#pragma once

/// The words for people after `pelt check`.

#include "tools/pelt/check/check_run.hpp"

#include <ostream>

namespace pelt::tools::check {

void print_summary(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                   const CheckSettings& settings, const CheckReport& report,
                   const TouchTally& tally, std::ostream& out);

}  // namespace pelt::tools::check
