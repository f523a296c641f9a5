#pragma once

/// JSON as the command writes it, to files and to terminals.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pelt::tools::output {

/// JSON text: on one line without `indent`, else indented by so many spaces a level. Replaces bytes
/// that are not UTF-8, and escapes what a terminal would obey.
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace pelt::tools::output
