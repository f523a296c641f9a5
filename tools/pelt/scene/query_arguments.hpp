#pragma once

/// What the verbs that ask one question of every frame have in common on the command line.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <string>

namespace pelt::tools::scene {

struct QueryArguments {
  arguments::SceneArguments scene;
  std::string frames, jsonl, simd;
};

void add_query_options(arguments::Verb& verb, QueryArguments& arguments);

/// The scene and which frames of it.
struct QueryInput {
  scenes::Scene scene;
  arguments::FrameRange frames;
};

/// Loads what the arguments name and chooses the instructions to be used.
Result<QueryInput> open_query(const QueryArguments& arguments);

/// What --by names.
Result<Granularity> choose_granularity(const std::string& name);

}  // namespace pelt::tools::scene
