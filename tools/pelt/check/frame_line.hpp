#pragma once

/// The line of a frame in the output of `pelt check --jsonl`. Frames are queried on several
/// threads, and each thread puts the lines of its frames together.

#include <pelt/self_filter.hpp>
#include <pelt/surface.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/stage.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace pelt::tools::check {

/// Returns the line of a frame, without the line break. `geometry` describes the contacts of each
/// pair of the frame, unless empty.
std::string frame_line(const Stage& stage, const FrameAnswer& answer,
                       std::span<const ContactGeometry> geometry);

/// Returns the numbers of pairs of triangles that each filter leaves out, in one frame or in all.
nlohmann::ordered_json left_out_json(const LeftOut& left_out);

}  // namespace pelt::tools::check
