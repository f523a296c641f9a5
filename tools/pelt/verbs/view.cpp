/// `pelt view`: the viewer, served to a browser of this machine.

#include "tools/pelt/arguments/input_files.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/page/page_server.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <memory>

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  arguments::SceneArguments scene;
  std::uint32_t port = 0;
  bool no_browser = false;
  std::string words;
};

constexpr const char* kFooter = R"(
Examples:
  pelt view
  pelt view scene.json
  pelt view knight.glb barbarian.glb --clip Walk --clip Attack
  pelt view scene.json --port 8000 --no-browser

The page does all work itself, also offline. The command serves the page to this machine only, until
Ctrl+C. `pelt check --html` writes the same page to a file.)";

Result<std::string> make_page(const Arguments& arguments) {
  if (arguments.scene.inputs.empty()) return page::read_viewer();
  const Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) return scene.error();
  const auto checked =
      output::check_outputs({}, arguments::files_of_scene(arguments.scene, *scene));
  if (!checked) return checked.error();
  return page::page_of_scene(*scene, arguments.scene.models, {arguments.words, std::nullopt});
}

Result<arguments::ExitCode> view(const Arguments& arguments) {
  const Result<std::string> page = make_page(arguments);
  if (!page) return page.error();
  const page::Browser browser =
      arguments.no_browser ? page::Browser::left_alone : page::Browser::opened;
  const Result<void> served =
      page::serve_page(*page, static_cast<std::uint16_t>(arguments.port), browser);
  if (!served) return served.error();
  return arguments::ExitCode::success;
}

}  // namespace

void add_view(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "view", "Show a scene and its contacts in a browser", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  arguments::add_scene_options(verb, arguments->scene, arguments::InputsNeeded::none);
  verb.option("--port", arguments->port, "Port on the loopback address (0: any free port)",
              {.type = "N", .most = 65535});
  verb.flag("--no-browser", arguments->no_browser, "Print the address and do not open a browser");
  verb.tells(arguments->words);
  verb.runs([arguments] { return view(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
