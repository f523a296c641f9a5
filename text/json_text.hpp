#pragma once

/// JSON text for files and terminals.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pelt::text {

/// JSON text, on one line without `indent`, otherwise indented by `indent` spaces per level.
/// Replaces bytes that are not UTF-8, and escapes code points that control terminals.
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace pelt::text
