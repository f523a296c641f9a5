#include "tools/pelt/bench/bench_report.hpp"
#include "tools/pelt/bench/machine_json.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::bench {
namespace {

using nlohmann::ordered_json;

ordered_json method_json(const Figures& figures) {
  const Times& times = figures.times;
  const ordered_json in_contact =
      times.frames_in_contact > 0 ? ordered_json(times.mean_contact_us) : ordered_json();
  return {{"method", figures.method},
          {"query", name_of(figures.variant.question)},
          {"cache", name_of(figures.variant.cache)},
          {"asked", name_of(figures.asked)},
          {"threads", figures.threads},
          {"frames", times.frames},
          {"mean_us", times.mean_us},
          {"mean_contact_us", in_contact},
          {"p95_us", times.p95_us},
          {"mean_update_us", times.mean_update_us},
          {"hash", output::hex16(figures.answer.hash)},
          {"counters", scene::counters_json(figures.answer.work)}};
}

ordered_json models_json(const SceneFigures& scene) {
  const ModelFigures& models = scene.models;
  ordered_json json = {{"triangles", models.triangles},
                       {"bytes", models.bytes},
                       {"build_seconds", models.build_seconds}};
  if (scene.self_filters) {
    json["self_filter_bytes"] = scene.self_filters->bytes;
    json["self_filter_build_seconds"] = scene.self_filters->build_seconds;
  }
  return json;
}

ordered_json scene_json(const SceneFigures& scene) {
  ordered_json methods = ordered_json::array();
  for (const Figures& figures : scene.figures) methods.push_back(method_json(figures));
  const Skinning& skinning = scene.skinning;
  ordered_json json = {{"scene", scene.scene},
                       {"frames", scene.frames},
                       {"frames_in_contact", scene.figures[0].answer.frames_in_contact},
                       {"repetitions", scene.repetitions},
                       {"time", name_of(scene.time)},
                       {"models", models_json(scene)},
                       {"skinning",
                        {{"vertices", skinning.vertices},
                         {"mean_us", skinning.mean_us},
                         {"ns_per_vertex", skinning.ns_per_vertex()}}},
                       {"methods", std::move(methods)}};
  if (scene.sequence)
    json["sequence"] = {{"self_us", scene.sequence->self_us},
                        {"tracked_us", scene.sequence->tracked_us}};
  return json;
}

}  // namespace

std::string figures_json(const std::vector<SceneFigures>& scenes) {
  ordered_json all = ordered_json::array();
  for (const SceneFigures& scene : scenes) all.push_back(scene_json(scene));
  const ordered_json figures = {{"format", "pelt-bench"},
                                {"version", 1},
                                {"machine", machine_json()},
                                {"scenes", std::move(all)}};
  return output::json_text(figures, 2) + "\n";
}

}  // namespace pelt::tools::bench
