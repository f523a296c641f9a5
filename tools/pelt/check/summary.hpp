#pragma once

/// The summary of `pelt check`.

#include "tools/pelt/check/check_run.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <ostream>

namespace pelt::tools::check {

void print_summary(const scene::StagedScene& staged, const CheckSettings& settings,
                   const CheckReport& report, const TouchTally& tally, std::ostream& out);

}  // namespace pelt::tools::check
