#pragma once

/// JSON of the arguments that the answers of frames depend on, in files of shards.

#include "tools/pelt/check/check_arguments.hpp"

#include <nlohmann/json_fwd.hpp>

namespace pelt::tools::shard {

/// Leaves out arguments of the outputs and of the machine. Arguments of the verdict are given only
/// for a list of scenes.
nlohmann::ordered_json arguments_json(const check::CheckArguments& arguments);

/// Sets the arguments that `arguments_json` wrote. Returns false if one is missing or has another
/// type.
bool read_arguments(const nlohmann::json& json, check::CheckArguments& arguments);

}  // namespace pelt::tools::shard
