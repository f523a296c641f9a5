#include "tools/pelt/scene/query_arguments.hpp"

#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"

#include <utility>

namespace pelt::tools::scene {

void add_query_options(arguments::Verb& verb, QueryArguments& arguments) {
  arguments::add_scene_options(verb, arguments.scene);
  verb.option(
      "--frames", arguments.frames,
      "Frames A to B - 1; with A:B:S every S-th of them (default: all frames of the scene or "
      "of the longest clip)",
      {.type = "A:B"});
  arguments::add_simd_option(verb, arguments.simd);
  verb.option("--jsonl", arguments.jsonl,
              "Write the answer, one JSON object per line; -: to standard output, with the summary "
              "on standard error",
              {.type = "FILE"});
}

Result<QueryInput> open_query(const QueryArguments& arguments) {
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) return scene.error();
  const Result<arguments::FrameRange> frames =
      arguments::choose_frames(arguments.frames, arguments.scene, *scene);
  if (!frames) return frames.error();
  const output::NamedOutput output = {"--jsonl", arguments.jsonl};
  const auto checked =
      output::check_outputs({&output, 1}, arguments::files_of_scene(arguments.scene, *scene));
  if (!checked) return checked.error();
  return QueryInput{std::move(*scene), *frames};
}

Result<Granularity> choose_granularity(const std::string& name) {
  if (name == "instance") return Granularity::instance;
  if (name == "part") return Granularity::part;
  return text::bad_argument("--by", "unknown value " + text::quoted(name), "give instance or part");
}

}  // namespace pelt::tools::scene
