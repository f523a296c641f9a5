/// `pelt info`: the contents of a model file.

#include "scenes/clip_samples.hpp"
#include "scenes/names.hpp"
#include "scenes/scene.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/prepared/prepared_file.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <set>

namespace pelt::tools::verbs {
namespace {

using nlohmann::ordered_json;

struct Arguments {
  std::string model;
  arguments::ModelArguments models;
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt info knight.glb
  pelt info knight.glb --json)";

std::size_t distinct_positions(const asset::Asset& asset) {
  std::set<std::array<float, 3>> places;
  for (const Vec3& p : asset.rest_positions) places.insert({p.x, p.y, p.z});
  return places.size();
}

/// The largest number of joints with positive weight of a vertex.
std::uint32_t most_influences(const asset::Asset& asset) {
  const std::uint32_t slots = asset.influences_per_vertex;
  std::ptrdiff_t most = 0;
  for (std::size_t begin = 0; begin < asset.weights.size(); begin += slots) {
    const auto weights = std::span(asset.weights).subspan(begin, slots);
    most = std::max(most, std::count_if(weights.begin(), weights.end(),
                                        [](float weight) { return weight > 0; }));
  }
  return static_cast<std::uint32_t>(most);
}

ordered_json clips_json(const asset::Asset& asset) {
  ordered_json clips = ordered_json::array();
  for (const asset::Clip& clip : asset.clips) {
    clips.push_back({{"name", clip.name}, {"duration", clip.duration}});
  }
  return clips;
}

ordered_json parts_json(const asset::Asset& asset) {
  ordered_json parts = ordered_json::array();
  const std::vector<std::string> names = scenes::part_names(asset);
  for (std::uint32_t p = 0; p < asset.parts.size(); ++p) {
    const asset::Part& part = asset.parts[p];
    parts.push_back({{"name", names[p]},
                     {"node", part.node},
                     {"mesh", part.mesh},
                     {"material", part.material},
                     {"first_triangle", part.first_triangle},
                     {"triangles", part.triangle_count},
                     {"skinned", part.skinned}});
  }
  return parts;
}

ordered_json joints_json(const asset::Asset& asset) {
  ordered_json joints = ordered_json::array();
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j)
    joints.push_back(scenes::joint_name(asset, j));
  return joints;
}

ordered_json morph_targets_json(const asset::Asset& asset) {
  ordered_json targets = ordered_json::array();
  for (std::size_t m = 0; m < asset.morph_targets.size(); ++m) {
    const asset::MorphTarget& target = asset.morph_targets[m];
    targets.push_back({{"name", target.name},
                       {"node", asset.nodes[target.node].name},
                       {"default_weight", target.default_weight},
                       {"displaced_vertices", asset.morph_begin[m + 1] - asset.morph_begin[m]}});
  }
  return targets;
}

ordered_json describe(const scenes::Character& character, const SkinnedModel& model) {
  const asset::Asset& asset = character.asset;
  const BuildReport& report = model.report();
  return {{"format", "pelt-info"},
          {"version", 1},
          {"model", character.source},
          {"hash", text::hex16(character.hash)},
          {"vertices", model.vertex_count()},
          {"distinct_positions", distinct_positions(asset)},
          {"triangles", model.triangle_count()},
          {"degenerate_triangles", report.degenerate_triangles},
          {"prepared_bytes", model.memory_bytes()},
          {"influences_per_vertex", most_influences(asset)},
          {"renormalised_vertices", report.renormalised_vertices},
          {"merged_influences", report.merged_influences},
          {"joints", joints_json(asset)},
          {"morph_targets", morph_targets_json(asset)},
          {"clips", clips_json(asset)},
          {"parts", parts_json(asset)},
          {"warnings", asset.warnings}};
}

template <typename T>
void print_line(const char* label, const T& value, const std::string& remark = {}) {
  std::cout << std::left << std::setw(11) << label << value << remark << '\n';
}

void print_counts(const ordered_json& info) {
  const auto number = [&](const char* key) {
    return text::with_commas(info[key].get<std::uint64_t>());
  };
  print_line("model", text::printable(info["model"].get<std::string>()));
  print_line("vertices", number("vertices"),
             ", at " + number("distinct_positions") + " distinct positions");
  print_line("triangles", number("triangles"),
             ", " + number("degenerate_triangles") + " of them degenerate at rest");
  print_line("influences", "up to " + number("influences_per_vertex"), " for each vertex");
  print_line("weights", number("renormalised_vertices"),
             " vertices renormalised, " + number("merged_influences") + " influences merged");
  if (!info["morph_targets"].empty())
    print_line("morphs", text::with_commas(info["morph_targets"].size()), " targets");
  print_line("prepared", number("prepared_bytes"), " bytes");
}

void print_clips(const asset::Asset& asset) {
  print_line("clips", text::with_commas(asset.clips.size()));
  for (const asset::Clip& clip : asset.clips) {
    std::cout << "  " << std::right << std::setw(8)
              << text::fixed(static_cast<double>(clip.duration), 3) << " s  "
              << (clip.name.empty() ? "\"\" (unnamed)" : text::printable_name(clip.name)) << '\n';
  }
}

void print_parts(const asset::Asset& asset) {
  print_line("parts", text::with_commas(asset.parts.size()));
  const std::vector<std::string> names = scenes::part_names(asset);
  for (std::uint32_t p = 0; p < asset.parts.size(); ++p) {
    const asset::Part& part = asset.parts[p];
    std::cout << "  " << std::right << std::setw(8) << text::with_commas(part.triangle_count)
              << " triangles  " << text::printable_name(names[p]) << "  (mesh "
              << text::quoted(part.mesh) << ", material " << text::quoted(part.material)
              << (part.skinned ? ")\n" : "; not skinned)\n");
  }
}

/// Prints the names as --ignore and baselines use them, as many per line as fit.
void print_joints(const asset::Asset& asset) {
  constexpr std::size_t kWidth = 100;
  print_line("joints", text::with_commas(asset.joints.size()));
  std::string line;
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j) {
    const std::string name = text::printable_name(scenes::joint_name(asset, j));
    const bool is_last = j + 1 == asset.joints.size();
    if (!line.empty() && line.size() + name.size() + 4 > kWidth) {
      std::cout << line << '\n';
      line.clear();
    }
    line += "  " + name + (is_last ? "" : ",");
  }
  if (!line.empty()) std::cout << line << '\n';
}

void print(const ordered_json& info, const asset::Asset& asset) {
  print_counts(info);
  print_clips(asset);
  print_joints(asset);
  print_parts(asset);
  for (const std::string& warning : asset.warnings) print_line("warning", text::printable(warning));
}

/// Returns an error if printing would overwrite or extend one of the files.
Result<void> check_standard_output(const std::vector<output::InputFile>& files) {
  return output::check_outputs({}, files);
}

Result<arguments::ExitCode> print_prepared(const Arguments& arguments) {
  const auto checked =
      check_standard_output({{arguments.model, "the prepared model " + arguments.model}});
  if (!checked) return checked.error();
  const auto printed = prepared::print_prepared_info(
      arguments.model, arguments.json ? prepared::InfoStyle::json : prepared::InfoStyle::text);
  if (!printed) return printed.error();
  return arguments::ExitCode::success;
}

Result<arguments::ExitCode> info(const Arguments& arguments) {
  if (prepared::is_prepared_file(arguments.model)) return print_prepared(arguments);
  const Result<scenes::Character> character =
      arguments::load_named_character(arguments.model, arguments.models.gltf_options(),
                                      "a glTF file, .glb or .gltf, or a prepared model, .pelt");
  if (!character) return character.error();
  const auto checked = check_standard_output(arguments::files_of_model(arguments.model));
  if (!checked) return checked.error();
  const asset::Asset& asset = character->asset;
  const std::uint32_t samples = arguments.models.samples;
  const Result<SkinnedModel> model = arguments::build_named_model(
      *character, asset.mesh(), arguments.models,
      scenes::clip_samples(asset, scenes::first_clips(asset, samples), samples));
  if (!model) return model.error();
  const ordered_json description = describe(*character, *model);
  if (arguments.json) {
    std::cout << text::json_text(description, 2) << '\n';
  } else {
    print(description, asset);
  }
  return arguments::ExitCode::success;
}

}  // namespace

void add_info(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "info", "Print what a model file contains", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("MODEL", arguments->model, "A glTF file, .glb or .gltf, or a prepared model",
              {.is_required = true});
  verb.flag("--json", arguments->json, "Print JSON");
  arguments::add_model_options(verb, arguments->models);
  verb.runs([arguments] { return info(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
