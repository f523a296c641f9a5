#pragma once

/// Compact text of the contacts of a frame in files of shards. Nearly all of such a file is
/// contacts, and `pelt merge` reads all of them.
///
/// A number is written in digits of 5 bits, the lowest first, as characters from '0' on; all digits
/// but the last one have 32 added. A pair of colliders is a, b, the number of its contacts, and
/// their triangles. These are differences from the contact before (at first from 0): that of
/// triangle_a, which is not negative, and twice the size of that of triangle_b, plus 1 if it is
/// negative. Contacts ascend, so most differences have one to three digits.

#include "tools/pelt/scene/scene_query.hpp"

#include <span>
#include <string>
#include <string_view>

namespace pelt::tools::shard {

/// Appends the contacts of a frame to `text`, without the end of the line.
void add_contacts(const scene::FrameContacts& found, std::string& text);

/// Appends the contacts of a text to `found`, which must be empty. Returns false unless pairs and
/// contacts ascend and all colliders and triangles exist.
bool read_contacts(std::string_view text, std::span<const scene::Collider> colliders,
                   scene::FrameContacts& found);

}  // namespace pelt::tools::shard
