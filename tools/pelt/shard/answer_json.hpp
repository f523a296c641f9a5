#pragma once

/// JSON of the answers of frames in files of shards.

#include <pelt/result.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace pelt::tools::shard {

/// Returns all of an answer. Numbers keep their bits.
nlohmann::ordered_json answer_json(const check::FrameAnswer& answer);

/// The scene and the frame that an answer must belong to.
struct Expected {
  const scene::StagedScene& staged;
  std::uint32_t frame = 0;
  std::optional<std::uint32_t> step_from;  ///< the frame before, if a step ends with the frame
};

/// Returns the answer that `answer_json` wrote. Returns an error, without a place, for values that
/// no answer of the frame has: other frames, bodies, triangles or joints that do not exist, and
/// lists that are not in order.
Result<check::FrameAnswer> read_answer(const nlohmann::json& json, const Expected& expected);

}  // namespace pelt::tools::shard
