/// `pelt pose`: writes the characters of one frame, as queries pose them, to a .glb file.

#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/verbs/commands.hpp"

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  arguments::SceneArguments scene;
  std::uint32_t frame = 0;
  std::string output;
};

constexpr const char* kFooter = R"(
Examples:
  pelt pose scene.json --frame 20 -o posed.glb
  pelt pose knight.glb --clip Walk --frame 12 -o knight_12.glb

Each instance becomes a root node without a transform, in the order of the scene, with one mesh of
one primitive. The file has all vertices. The positions have the same bits as those that `pelt check`
tests. The triangles have the same numbers as in its answers.)";

Result<arguments::ExitCode> pose(const Arguments& arguments) {
  Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) return scene.error();
  const std::string only =
      std::to_string(arguments.frame) + ":" + std::to_string(std::uint64_t{arguments.frame} + 1);
  const auto chosen = arguments::choose_frames(only, arguments.scene, *scene);
  if (!chosen) {
    return text::bad_argument("--frame",
                              std::to_string(arguments.frame) + " is beyond the last frame",
                              scene->name + " has " + text::counted(scene->frame_count, "frame"));
  }
  const output::NamedOutput output = {"--output", arguments.output};
  const auto checked =
      output::check_outputs({&output, 1}, arguments::files_of_scene(arguments.scene, *scene));
  if (!checked) return checked.error();
  output::OutputFile file;
  if (const auto opened = file.open(arguments.output); !opened) return opened.error();
  const auto posed = scene::pose_instances(*scene, arguments.frame, arguments.scene.models);
  if (!posed) return posed.error();
  if (const auto written = file.write_and_close(scene::posed_glb(*posed)); !written)
    return written.error();
  output::print_written(arguments.output, output::words_beside({arguments.output}));
  return arguments::ExitCode::success;
}

}  // namespace

void add_pose(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "pose", "Write the posed characters of one frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  arguments::add_scene_options(verb, arguments->scene);
  verb.option("--frame", arguments->frame, "The frame to write",
              {.type = "N", .is_required = true});
  verb.option("-o,--output", arguments->output, "The .glb file to write",
              {.type = "FILE", .is_required = true});
  verb.runs([arguments] { return pose(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
