/// `pelt prepare`: builds a model and writes it to a file that loads much faster.

#include <pelt/model.hpp>

#include "scenes/clip_samples.hpp"
#include "scenes/scene.hpp"
#include "text/format.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/prepared/prepared_file.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <ostream>

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  std::string model;
  arguments::ModelArguments models;
  std::string output;
};

constexpr const char* kFooter = R"(
Examples:
  pelt prepare knight.glb -o knight.pelt
  pelt info knight.pelt

pelt::load_model() reads and validates the file in a fraction of the time that building takes. The
file contains only the model; skeleton and clips stay in the glTF file. Another version of Pelt may
require the model to be prepared again.)";

template <typename Work>
double milliseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// The least of several times: programs load many models, and only the first load has to allocate
/// from the system.
double loading_milliseconds(std::span<const std::byte> file) {
  constexpr int kRepeats = 9;
  double least = milliseconds([&] { static_cast<void>(load_model(file)); });
  for (int i = 1; i < kRepeats; ++i)
    least = std::min(least, milliseconds([&] { static_cast<void>(load_model(file)); }));
  return least;
}

std::ostream& label(std::ostream& out, const char* name) {
  return out << std::left << std::setw(11) << name;
}

/// A built model with its number of sample poses and build time.
struct Prepared {
  SkinnedModel model;
  std::size_t sample_poses;
  double build_ms;
};

Result<Prepared> build(const scenes::Character& character,
                       const arguments::ModelArguments& arguments) {
  const asset::Asset& asset = character.asset;
  const std::vector<Matrix4> samples =
      scenes::clip_samples(asset, scenes::first_clips(asset, arguments.samples), arguments.samples);
  Result<SkinnedModel> model = Error{};
  const double build_ms = milliseconds(
      [&] { model = arguments::build_named_model(character, asset.mesh(), arguments, samples); });
  if (!model) return model.error();
  return Prepared{*model, samples.size() / asset.joints.size(), build_ms};
}

void print(const scenes::Character& character, const Prepared& prepared, std::ostream& out) {
  const SkinnedModel& model = prepared.model;
  label(out, "model") << text::printable(character.source) << ": "
                      << text::with_commas(model.vertex_count()) << " vertices, "
                      << text::with_commas(model.triangle_count()) << " triangles, "
                      << text::counted(model.joint_count(), "joint") << '\n';
  label(out, "samples") << text::counted(prepared.sample_poses, "pose") << " of "
                        << text::counted(character.asset.clips.size(), "clip") << '\n';
  label(out, "build") << text::fixed(prepared.build_ms, 2) << " ms\n";
}

void print(const std::string& output, std::span<const std::byte> file, double build_ms,
           std::ostream& out) {
  const double load_ms = loading_milliseconds(file);
  label(out, "prepared") << text::with_commas(file.size()) << " bytes\n";
  label(out, "load") << text::fixed(load_ms, 2) << " ms, " << text::fixed(build_ms / load_ms, 0)
                     << " times faster\n";
  output::print_written(output, out);
}

Result<arguments::ExitCode> prepare(const Arguments& arguments) {
  const Result<scenes::Character> character = arguments::load_named_character(
      arguments.model, arguments.models.gltf_options(), "a glTF file, .glb or .gltf");
  if (!character) return character.error();
  const output::NamedOutput output = {"--output", arguments.output};
  const auto checked =
      output::check_outputs({&output, 1}, arguments::files_of_model(arguments.model));
  if (!checked) return checked.error();
  output::OutputFile output_file;
  if (const auto opened = output_file.open(arguments.output); !opened) return opened.error();
  const Result<Prepared> prepared = build(*character, arguments.models);
  if (!prepared) return prepared.error();
  const std::vector<std::byte> file = save_model(prepared->model);
  const Result<SkinnedModel> loaded = prepared::load_named_model(arguments.output, file);
  if (!loaded) return loaded.error();
  if (const auto written = output_file.write_and_close(file); !written) return written.error();
  std::ostream& words = output::words_beside({arguments.output});
  print(*character, *prepared, words);
  print(arguments.output, file, prepared->build_ms, words);
  return arguments::ExitCode::success;
}

}  // namespace

void add_prepare(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "prepare", "Build a model and write it to a file that loads fast",
                       kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("MODEL", arguments->model, "A glTF file, .glb or .gltf", {.is_required = true});
  verb.option("-o,--output", arguments->output, "The prepared model to write (.pelt)",
              {.type = "FILE", .is_required = true});
  arguments::add_model_options(verb, arguments->models);
  verb.runs([arguments] { return prepare(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
