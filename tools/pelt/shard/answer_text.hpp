#pragma once

/// Text of the answers of frames in files of shards: a line of JSON, the frame's line of --jsonl,
/// and a line with its contacts, which need a faster reader.

#include <pelt/result.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>

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

/// Appends the contacts of a frame to `text`, without the end of the line, as compact text: nearly
/// all of a file is contacts, and `pelt merge` reads all of them.
///
/// A number is written in digits of 5 bits, the lowest first, as characters from '0' on; all digits
/// but the last one have 32 added. A pair of colliders is a, b, the number of its contacts, and
/// their triangles. These are differences from the contact before (at first from 0): that of
/// triangle_a, which is not negative, and twice the size of that of triangle_b, plus 1 if it is
/// negative. Contacts ascend, so most differences have one to three digits.
void add_contacts(const scene::FrameContacts& found, std::string& text);

/// Appends the contacts of a text to `found`, which must be empty. Returns false unless pairs and
/// contacts ascend and all colliders and triangles exist.
bool read_contacts(std::string_view text, std::span<const scene::Collider> colliders,
                   scene::FrameContacts& found);

}  // namespace pelt::tools::shard
