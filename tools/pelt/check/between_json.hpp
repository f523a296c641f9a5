#pragma once

/// JSON of `pelt check --between`.

#include "tools/pelt/check/between_check.hpp"
#include "tools/pelt/check/step_contacts.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace pelt::tools::check {

/// Returns the line of a step with contacts between its frames. `lists_triangles`: also all
/// contacts, with times and features.
nlohmann::ordered_json step_json(const scene::StagedScene& staged, const StepContacts& step,
                                 bool lists_triangles);

/// Returns `totals.between`.
nlohmann::ordered_json between_json(const scene::StagedScene& staged, const BetweenReport& report);

/// Returns a touch between frames, with steps instead of frames.
nlohmann::ordered_json touch_between_json(const scene::StagedScene& staged, const Touch& touch);

}  // namespace pelt::tools::check
