/// `pelt view`: writes a page of a scene and opens it in a browser.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <stdlib.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace pelt::tools::verbs {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  arguments::SceneArguments scene;
  std::string output;
  bool no_browser = false;
  std::string words;
};

constexpr const char* kFooter = R"(
Examples:
  pelt view
  pelt view scene.json
  pelt view knight.glb barbarian.glb --clip Walk --clip Attack
  pelt view scene.json -o page.html --no-browser

The page is one file and does all work itself, also offline. Without -o, the page goes to a new folder
in TMPDIR (or /tmp) and stays there, because the browser may read it again; most systems empty this
folder when they start. If the browser cannot read this folder, choose another one with -o.
`pelt check --html` also writes such a page, with the answer of the check.)";

/// Returns the path of a page in a new folder that other users cannot read, because the page
/// contains the models.
Result<std::string> temporary_page() {
  std::error_code error;
  std::string folder = fs::temp_directory_path(error) / "pelt-XXXXXX";
  if (!error && mkdtemp(folder.data()) != nullptr) return folder + "/view.html";
  return Error{
      ErrorCode::unreadable_file,
      "the page: there is no folder for temporary files: name a file with -o, or set TMPDIR to "
      "a folder"};
}

/// xdg-open may run until the browser is closed. In a session of its own, it survives Ctrl+C.
void open_browser(const std::string& page, std::ostream& words) {
  words.flush();
  const std::vector<std::string> command = {"setsid", "xdg-open", fs::absolute(page).string()};
  if (output::run_program(command) != output::ProgramEnd::succeeded)
    words << "no browser was opened: open this file in a browser\n";
}

/// Returns an error if the page would replace a file that it is made from.
Result<void> check_output(const Arguments& arguments, const scenes::Scene* scene) {
  std::vector<output::InputFile> inputs;
  if (scene != nullptr) inputs = arguments::files_of_scene(arguments.scene, *scene);
  for (const fs::path& place : page::viewer_places())
    inputs.push_back({place, "the viewer's page"});
  const output::NamedOutput output = {"--output", arguments.output};
  return output::check_outputs({&output, 1}, inputs);
}

Result<arguments::ExitCode> view(const Arguments& arguments) {
  std::optional<scenes::Scene> scene;
  if (!arguments.scene.inputs.empty()) {
    Result<scenes::Scene> opened = arguments::open_scene(arguments.scene);
    if (!opened) return opened.error();
    scene = std::move(*opened);
  }
  if (const auto checked = check_output(arguments, scene ? &*scene : nullptr); !checked)
    return checked.error();
  Result<std::string> page = page::read_viewer();
  if (!page) return page.error();
  const Result<std::string> name = arguments.output.empty() ? temporary_page() : arguments.output;
  if (!name) return name.error();
  output::OutputFile file;
  if (const auto opened = file.open(*name); !opened) return opened.error();
  if (scene)
    page = page::page_of_scene(*scene, arguments.scene.models, {arguments.words, std::nullopt});
  if (!page) return page.error();
  if (const auto written = file.write_and_close(std::as_bytes(std::span(*page))); !written)
    return written.error();
  std::ostream& words = output::words_beside({*name});
  output::print_written(*name, words);
  if (!arguments.no_browser && !output::is_standard_output(*name)) open_browser(*name, words);
  return arguments::ExitCode::success;
}

}  // namespace

void add_view(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "view", "Show a scene and its contacts in a browser", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  arguments::add_scene_options(verb, arguments->scene, arguments::InputsNeeded::none);
  verb.option("-o,--output", arguments->output, "The page to write (default: a temporary file)",
              {.type = "FILE"});
  verb.flag("--no-browser", arguments->no_browser, "Write the page and do not open a browser");
  verb.tells(arguments->words);
  verb.runs([arguments] { return view(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
