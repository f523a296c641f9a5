#pragma once

/// Command line options shared by the verbs that query every frame.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <string>

namespace pelt::tools::scene {

struct QueryArguments {
  arguments::SceneArguments scene;
  std::string frames, jsonl, simd;
};

void add_query_options(arguments::Verb& verb, QueryArguments& arguments);

/// The scene and the selected frames.
struct QueryInput {
  scenes::Scene scene;
  arguments::FrameRange frames;
};

/// Loads the scene and selects the instruction set.
Result<QueryInput> open_query(const QueryArguments& arguments);

/// Parses --by.
Result<Granularity> choose_granularity(const std::string& name);

}  // namespace pelt::tools::scene
