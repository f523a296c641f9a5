/// The comparison over a clip: caches, slow frames, memory.

#include "evaluation/bench/bench.hpp"
#include "evaluation/reproduce/comparison_methods.hpp"
#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/heap_bytes.hpp"
#include "evaluation/reproduce/method_title.hpp"
#include "evaluation/reproduce/scene_texts.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/bench_scene.hpp"

#include <algorithm>
#include <sstream>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

constexpr std::uint32_t kFrames = 30;

/// In the middle of the clip, two creatures intersect deeply.
constexpr std::uint32_t kMiddle = 60;

Result<tools::bench::SceneFigures> measure_clip(const scenes::Scene& scene,
                                                const Conditions& conditions) {
  tools::bench::BenchSettings settings;
  settings.program = "pelt-lab";
  for (const MethodKind method : kCompared)
    settings.methods.push_back(tools::bench::method_of(method));
  settings.questions = {Question::all};
  settings.caches = {tools::bench::Cache(), lab::cold_cache()};
  settings.repetitions = conditions.is_quick ? 3 : 9;
  const std::uint32_t frames = conditions.is_quick ? kFrames / 5 : kFrames;
  settings.frames = tools::arguments::FrameRange{0, scene.frame_count, scene.frame_count / frames};
  std::ostringstream errors;
  auto figures = tools::bench::bench_scene(scene, settings, errors);
  if (!figures) return figures.error();
  if (!*figures) return Error{ErrorCode::invalid_argument, errors.str()};
  return std::move(**figures);
}

const tools::bench::Times& times_of(const tools::bench::SceneFigures& figures, MethodKind method,
                                    const char* cache) {
  return std::find_if(figures.figures.begin(), figures.figures.end(),
                      [&](const tools::bench::Figures& of) {
                        return of.method == method.name && of.cache == cache;
                      })
      ->times;
}

/// Memory that a method uses for `count` instances of a model after a query of a pair that
/// intersects deeply, without the model.
std::optional<double> bytes_of(MethodKind method, const SkinnedModel& model,
                               std::span<const std::vector<Matrix4>> palettes,
                               std::uint32_t instances) {
  const std::optional<std::size_t> before = heap_bytes();
  const auto made = method.make();
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < instances; ++i) {
    made->add(model);
    (void)made->set_palette(i, palettes[i % 2]);
  }
  for (std::uint32_t i = 0; i + 1 < instances; i += 2) made->collide(i, i + 1, contacts, {});
  contacts = {};
  const std::optional<std::size_t> after = heap_bytes();
  if (!before || !after) return std::nullopt;
  return static_cast<double>(*after) - static_cast<double>(*before);
}

/// KiB per additional instance, and KiB that exist once.
struct Memory {
  Cell instance, shared;
};

Memory memory_of(MethodKind method, const SkinnedModel& model,
                 std::span<const std::vector<Matrix4>> palettes) {
  const auto two = bytes_of(method, model, palettes, 2),
             four = bytes_of(method, model, palettes, 4);
  if (!two || !four) return {};
  const double each = (*four - *two) / 2;
  return {each / 1024, std::max(*two - 2 * each, 0.0) / 1024};
}

std::string note_of(const tools::bench::SceneFigures& figures, const Conditions& conditions) {
  return how_measured(text::counted(figures.frames, "frame") + ", " +
                          std::to_string(figures.figures[0].answer.frames_in_contact) +
                          " of them in contact; all contacts. Cold: 64 MB are read before every "
                          "frame, which empties the caches.",
                      conditions) +
         " Memory: allocated by a method after frame " + std::to_string(kMiddle) +
         ", computed from four instances and from two. The model of Pelt, " +
         shown(static_cast<double>(figures.models.bytes) / 1024) +
         " KiB, from which all methods start, is excluded; with Pelt, instances share nothing "
         "else.";
}

}  // namespace

Result<Table> clip_table(const Conditions& conditions) {
  const auto scene = scenes::parse_scene(passing_through_scene(), {});
  if (!scene) return scene.error();
  const auto figures = measure_clip(*scene, conditions);
  if (!figures) return figures.error();
  const auto colliders =
      tools::scene::make_colliders(*scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(*scene, kMiddle, scratch, palettes);
  Table table = {"clip",
                 "Two creatures walk through each other",
                 {{"method", "method"},
                  {"hot_us", "hot caches, mean [us]"},
                  {"p95_us", "95 % of frames are below [us]"},
                  {"cold_us", "cold caches, mean [us]"},
                  {"instance_kib", "memory of an instance [KiB]"},
                  {"shared_kib", "shared by all [KiB]"}},
                 {},
                 note_of(*figures, conditions)};
  for (const MethodKind method : kCompared) {
    const tools::bench::Times& hot = times_of(*figures, method, "hot");
    const Memory memory = memory_of(method, (*colliders)[0].model, palettes.joints);
    table.rows.push_back({title_of(method), hot.mean_us, hot.p95_us,
                          times_of(*figures, method, "cold").mean_us, memory.instance,
                          memory.shared});
  }
  return table;
}

}  // namespace pelt::reproduce
