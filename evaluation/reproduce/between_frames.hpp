#pragma once

/// The tables of the section on queries between frames.

#include "evaluation/reproduce/report.hpp"
#include "scenes/scene.hpp"

#include <string>

namespace pelt::reproduce {

/// The queries between frames on at most `most_steps` evenly spaced steps of a scene (in a quick
/// run a fourth of that), one row for each query and method. Fails if methods give different
/// answers.
Result<Table> between_frames_table(const std::string& id, const std::string& title,
                                   const scenes::Scene& scene, std::uint32_t most_steps,
                                   const Conditions& conditions);

}  // namespace pelt::reproduce
