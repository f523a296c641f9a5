#pragma once

/// The lines of frames and of steps of `pelt check --jsonl`.

#include <pelt/surface.hpp>

#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/check/steps.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace pelt::tools::check {

/// Returns the line of a frame without its end. `geometry` describes the contacts of each pair of
/// the frame, unless empty.
std::string frame_line(const Stage& stage, const FrameAnswer& answer,
                       std::span<const ContactGeometry> geometry);

/// Returns the line of a step with contacts between its frames. `lists_triangles`: also all
/// contacts, with times and features.
nlohmann::ordered_json step_json(const scene::StagedScene& staged, const StepContacts& step,
                                 bool lists_triangles);

nlohmann::ordered_json left_out_json(const LeftOut& left_out);

/// A contact of a step, with its first time and the features that meet.
nlohmann::ordered_json first_touch_json(const Contact& contact, const FirstTouch& first);

/// Adds the frame from which a step starts, as `step`.
void add_step(const scenes::Scene& scene, std::uint32_t from, nlohmann::ordered_json& object);

}  // namespace pelt::tools::check
