#pragma once

/// Parsing of untrusted JSON texts.

#include <pelt/result.hpp>

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string_view>

namespace pelt::asset {

/// Destroys a JSON value from the leaves up. The destructor of nlohmann::json allocates, and ends
/// the program if memory has run out. Precondition: nested as `parse_json` allows.
struct JsonEnd {
  void operator()(nlohmann::json* value) const;
};

/// Owns a parsed text.
using ParsedJson = std::unique_ptr<nlohmann::json, JsonEnd>;

/// Parses a whole JSON text. The result is not null. Of equal keys in an object, the last one
/// counts. Rejects texts nested deeper than any glTF file needs, before they cost stack or memory.
/// If memory runs out, throws std::bad_alloc after freeing what it has parsed.
Result<ParsedJson> parse_json(std::string_view text);

}  // namespace pelt::asset
