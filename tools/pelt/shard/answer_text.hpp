#pragma once

/// Text of the answers of frames in files of shards: a line of JSON, the frame's line of --jsonl,
/// and a line with its contacts, which need a faster reader.

#include <pelt/result.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace pelt::tools::shard {

/// Returns all of an answer, as three lines with their ends. Numbers keep their bits.
std::string answer_text(const check::FrameAnswer& answer);

/// The lines of an answer, without their ends.
struct AnswerLines {
  std::string values, line, contacts;
};

/// Reads the next answer's lines. Returns false if the file ends before.
bool read_lines(std::istream& in, AnswerLines& lines);

/// The scene and the frame that an answer must belong to.
struct Expected {
  const scene::StagedScene& staged;
  std::uint32_t frame = 0;
  std::optional<std::uint32_t> step_from;  ///< the frame before, if a step ends with the frame
};

/// Reads the answer that `answer_text` wrote; `lines` is then unspecified. Returns an error,
/// without a place, for values that no answer of the frame has: other frames, bodies, triangles or
/// joints that do not exist, and lists that are not in order.
Result<check::FrameAnswer> read_answer(AnswerLines& lines, const Expected& expected);

}  // namespace pelt::tools::shard
