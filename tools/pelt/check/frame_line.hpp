#pragma once

/// The line of a frame of `pelt check --jsonl`.

#include "tools/pelt/check/check_question.hpp"
#include "tools/pelt/check/contact_details.hpp"
#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pelt::tools::check {

/// Returns the line without its end. `details` describes the contacts of the frame, unless null.
std::string frame_line(const scene::StagedScene& staged, const CheckQuestion& question,
                       const FrameAnswer& answer, const ContactDetails* details);

nlohmann::ordered_json left_out_json(const LeftOut& left_out);

}  // namespace pelt::tools::check
