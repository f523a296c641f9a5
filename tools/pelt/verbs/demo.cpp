/// `pelt demo`: two generated characters walk into each other. Needs no input files.

#include "scenes/demo.hpp"
#include "asset/file_bytes.hpp"
#include "scenes/character_glb.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/check.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/picture/still.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <array>
#include <filesystem>
#include <iostream>

namespace pelt::tools::verbs {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder = "pelt-demo";
  bool no_picture = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt demo
  pelt demo -o pictures
  pelt demo --no-picture

Writes scene.json (then try `pelt check pelt-demo/scene.json`), azure.glb and sand.glb (its two
characters, with skins and clips), contacts.jsonl (every pair of intersecting triangles in every
frame), contacts.glb (the worst frame, for any glTF viewer), report.html (a page that plays the whole
clip in a browser) and still.png (a picture of one frame, rendered by POV-Ray). Also writes sword.json
and sword.glb, a scene for `pelt check pelt-demo/sword.json --between`: a sword that passes through an
arm between two frames.)";

/// The frame of still.png.
constexpr std::uint32_t kStillFrame = 40;

constexpr const char* kPicture = "still.png";
constexpr const char* kDescription = "still.pov";

Result<void> write_text(const fs::path& path, std::string_view text) {
  return output::write_file(path, std::as_bytes(std::span(text)));
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (fs::is_directory(folder, error)) return {};
  return Error{
      ErrorCode::unreadable_file,
      folder.string() + ": is not a folder and cannot be created: choose another folder with -o"};
}

Result<scenes::Scene> write_scene(const fs::path& folder) {
  const fs::path path = folder / "scene.json";
  if (const auto written = write_text(path, scenes::kDemoScene); !written) return written.error();
  output::print_written(path.string(), std::cout);
  return scenes::load_scene(path);
}

/// Writes the generated characters to files.
Result<void> write_characters(const scenes::Scene& scene, const fs::path& folder) {
  for (const scenes::Character& character : scene.characters) {
    const fs::path path = folder / (character.name + ".glb");
    const auto written = output::write_file(path, scenes::character_glb(character.asset));
    if (!written) return written;
    output::print_written(path.string(), std::cout);
  }
  return {};
}

/// Writes the scene of a sword and the sword. The other character is that of the first scene.
Result<void> write_sword(const fs::path& folder) {
  const fs::path scene = folder / "sword.json", sword = folder / "sword.glb";
  if (const auto written = write_text(scene, scenes::kSwordScene); !written) return written;
  output::print_written(scene.string(), std::cout);
  const auto written = output::write_file(sword, scenes::character_glb(scenes::make_sword()));
  if (!written) return written;
  output::print_written(sword.string(), std::cout);
  return {};
}

/// Also writes a report if `viewer` is a page.
Result<void> write_check(const scenes::Scene& scene, const fs::path& folder,
                         const Result<std::string>& viewer) {
  check::CheckSettings settings;
  settings.frames = {0, scene.frame_count};
  settings.options.pairs = true;
  settings.options.jsonl = (folder / "contacts.jsonl").string();
  settings.options.glb = (folder / "contacts.glb").string();
  if (viewer) settings.options.html = (folder / "report.html").string();
  settings.options.words = "pelt demo";
  const Result<check::CheckReport> report = check::check_scene(scene, settings, std::cout);
  if (!report) return report.error();
  return {};
}

/// Runs POV-Ray, which prints the picture, so that it writes no file of its own.
output::ProgramEnd render(const fs::path& description, std::string& picture) {
  const std::vector<std::string> command = {"povray", "+I" + description.string(),
                                            "+O-",    "+FN",
                                            "+W1280", "+H720",
                                            "+A0.2",  "+R2",
                                            "-D",     "-P",
                                            "+Q11"};
  return output::run_program(command, &picture);
}

/// A missing ray tracer does not fail the demo, which writes everything except the picture.
void say_why_not(output::ProgramEnd end, const fs::path& description) {
  if (end == output::ProgramEnd::not_found) {
    std::cout << "no picture: POV-Ray is not installed. Run `apt-get install povray`, then "
                 "`pelt demo` again\n";
    return;
  }
  const std::string name = text::printable(description.string());
  std::cout << "no picture: POV-Ray failed on " << name << "; run `povray " << name
            << "` to see why\n";
}

/// Keeps the picture's description only if rendering fails.
Result<void> write_picture(const scenes::Scene& scene, const fs::path& folder) {
  const Result<picture::StillFrame> still = picture::take_still(scene, kStillFrame);
  if (!still) return still.error();
  const fs::path description = folder / kDescription, path = folder / kPicture;
  const output::UnfinishedFile unfinished(description);  // unless rendering fails
  if (const auto written = write_text(description, picture::describe_still(*still)); !written)
    return written.error();
  std::cout << "rendering ..." << std::endl;
  std::string picture;
  const output::ProgramEnd end = render(description, picture);
  if (end != output::ProgramEnd::succeeded) {
    say_why_not(end, description);
    return {};
  }
  if (const auto written = write_text(path, picture); !written) return written.error();
  output::print_written(path.string(), std::cout);
  std::error_code ignored;
  fs::remove(description, ignored);
  return {};
}

/// All files that the demo may write.
constexpr std::array kFiles = {"scene.json", "azure.glb",      "sand.glb",     "sword.json",
                               "sword.glb",  "contacts.jsonl", "contacts.glb", "report.html",
                               kDescription, kPicture};

/// A demo writes its scene first, so the other files of a folder with this scene are of a demo too.
bool holds_a_demo(const fs::path& folder) {
  const auto scene = asset::read_file(folder / "scene.json");
  if (!scene) return false;
  const auto* text = reinterpret_cast<const char*>(scene->data());
  return std::string_view(text, scene->size()) == scenes::kDemoScene;
}

/// Returns an error for a folder with a file that the demo would replace but has not written.
Result<void> check_contents(const fs::path& folder) {
  if (holds_a_demo(folder)) return {};
  for (const char* name : kFiles) {
    std::error_code ignored;
    const fs::path path = folder / name;
    if (!fs::exists(fs::symlink_status(path, ignored))) continue;
    return text::bad_argument("-o", path.string() + " exists, and is not of a demo",
                              "choose another folder with -o, or move the file away");
  }
  return {};
}

/// Returns an error for a folder in which links make two of the demo's files the same, or one of
/// them the viewer's page.
Result<void> check_links(const fs::path& folder) {
  std::vector<output::NamedOutput> outputs;
  outputs.reserve(std::size(kFiles));
  for (const char* name : kFiles) outputs.push_back({"-o", (folder / name).string()});
  std::vector<output::InputFile> inputs;
  for (const fs::path& place : page::viewer_places())
    inputs.push_back({place, "the viewer's page"});
  return output::check_outputs(outputs, inputs);
}

Result<arguments::ExitCode> demo(const Arguments& arguments) {
  const fs::path folder = arguments.folder;
  if (const auto made = make_folder(folder); !made) return made.error();
  if (const auto checked = check_links(folder); !checked) return checked.error();
  if (const auto checked = check_contents(folder); !checked) return checked.error();
  const Result<scenes::Scene> scene = write_scene(folder);
  if (!scene) return scene.error();
  if (const auto written = write_characters(*scene, folder); !written) return written.error();
  if (const auto written = write_sword(folder); !written) return written.error();
  // A missing viewer does not fail the demo either.
  const Result<std::string> viewer = page::read_viewer();
  if (const auto written = write_check(*scene, folder, viewer); !written) return written.error();
  if (!viewer) std::cout << "no report: " << text::printable(viewer.error().message) << '\n';
  if (arguments.no_picture) return arguments::ExitCode::success;
  if (const auto written = write_picture(*scene, folder); !written) return written.error();
  return arguments::ExitCode::success;
}

}  // namespace

void add_demo(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "demo", "Check a scene of two generated characters", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("-o,--output", arguments->folder, "Folder for the files", {.type = "DIR"});
  verb.flag("--no-picture", arguments->no_picture,
            "Leave out the picture, which takes most of the time");
  verb.runs([arguments] { return demo(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
