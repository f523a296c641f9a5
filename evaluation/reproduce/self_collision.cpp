/// Characters against themselves: how the time grows with the number of triangles, and how it
/// splits.

#include "evaluation/reproduce/self_collision.hpp"

#include <pelt/self.hpp>

#include "collide/eager.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/growth.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/rivals/stages.hpp"
#include "model/model.hpp"
#include "scenes/takes.hpp"
#include "self/self_filter.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <algorithm>
#include <array>

namespace pelt::reproduce {
namespace {

using tools::bench::Figures;
using tools::bench::Question;
using tools::bench::SceneFigures;

/// The filter without fans: the query then finds only pairs that share no surface vertex.
SelfFilter without_fans(const SelfFilter& filter) {
  const auto copy = std::make_shared<detail::SelfFilter>(filter.detail());
  copy->fans.runs.clear();
  return SelfFilter(copy);
}

template <typename Work>
double time_us(const Work& work) {
  tools::bench::Stopwatch watch;
  work();
  watch.stop();
  return watch.microseconds();
}

/// One character, and the memory of its queries.
class StageRun {
 public:
  StageRun(const SkinnedModel& model, const SelfFilter& filter)
      : pose_(model),
        exact_(model.detail().tree),
        filter_(filter),
        without_fans_(reproduce::without_fans(filter)) {}

  /// Times all stages once, on a pose that differs from the last one.
  Result<void> repeat(std::span<const Matrix4> palette) {
    if (const auto taken = exact_.set_palette(palette); !taken) return taken;
    add(0, [&] { exact_.open_all(); });
    const detail::PosedTree posed = exact_.posed_tree();
    const detail::PairMasks& masks = filter_.detail().masks;
    add(1, [&] { rivals::active_box_all_triangles()(posed, masks, tree_scratch_); });
    add(2, [&] { rivals::active_descend_self()(posed, masks); });
    const double without_fans_us = query_us(palette, without_fans_);
    times_[4].push_back(query_us(palette, filter_));
    times_[3].push_back(std::max(0.0, times_[4].back() - without_fans_us));
    return {};
  }

  /// Ends a frame: the medians of its repetitions.
  void end_frame() {
    for (std::size_t stage = 0; stage < times_.size(); ++stage) {
      frames_[stage].push_back(tools::output::median(times_[stage]));
      times_[stage].clear();
    }
  }

  SelfStages means() const {
    const auto mean = [&](std::size_t stage) { return tools::output::mean(frames_[stage]); };
    return {mean(0), mean(1), mean(2), mean(3), mean(4)};
  }

 private:
  template <typename Work>
  void add(std::size_t stage, const Work& work) {
    times_[stage].push_back(time_us(work));
  }

  double query_us(std::span<const Matrix4> palette, const SelfFilter& filter) {
    contacts_.clear();
    return time_us([&] {
      static_cast<void>(pose_.set_palette(palette));
      self_collide(pose_, filter, scratch_, contacts_);
    });
  }

  Pose pose_;
  detail::EagerPose exact_;
  SelfFilter filter_, without_fans_;
  Scratch scratch_;
  detail::Scratch tree_scratch_;
  std::vector<Contact> contacts_;
  std::array<std::vector<double>, 5> times_, frames_;
};

}  // namespace

Result<SelfStages> measure_self_stages(const scenes::Scene& scene, std::uint32_t most_frames,
                                       const Conditions& conditions) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  const SkinnedModel& model = colliders->front().model;
  const Result<SelfFilter> filter = build_self_filter(model);
  if (!filter) return filter.error();
  StageRun run(model, *filter);
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  const std::uint32_t most = conditions.is_quick ? std::max(most_frames / 4, 1u) : most_frames;
  const std::uint32_t step = (scene.frame_count + most - 1) / most;
  for (std::uint32_t frame = 0; frame < scene.frame_count; frame += step) {
    tools::scene::sample_palettes(scene, frame, scratch, palettes);
    for (std::uint32_t r = 0; r < (conditions.is_quick ? 3u : 9u); ++r)
      if (const auto done = run.repeat(palettes[0]); !done) return done.error();
    run.end_frame();
  }
  return run.means();
}

namespace {

constexpr std::array<std::uint32_t, 6> kSelfSizes = {1000, 3162, 10000, 31623, 100000, 316228};
constexpr std::size_t kQuickSizes = 3;
constexpr std::uint32_t kSelfFrames = 12;

double per_frame(std::uint64_t count, const SceneFigures& figures) {
  return static_cast<double>(count) / static_cast<double>(figures.frames);
}

std::vector<Cell> growth_row(std::uint32_t triangles, const SceneFigures& figures) {
  const Figures& all = figures_of(figures, "self", Question::all);
  const double boxes_us = figures_of(figures, "boxes", Question::all).times.mean_us;
  const auto filter_bytes = static_cast<double>(figures.self->filter_bytes);
  return {static_cast<double>(triangles),
          contact_count(figures),
          boxes_us,
          all.times.mean_us,
          figures_of(figures, "self", Question::first).times.mean_us,
          all.times.mean_us / boxes_us,
          per_frame(all.answer.work.node_pairs, figures),
          per_frame(all.answer.work.triangle_pairs, figures),
          filter_bytes / static_cast<double>(figures.models.triangles),
          1000 * figures.self->filter_build_seconds};
}

/// The share of a stage, in per cent.
double share(double stage_us, const SelfStages& stages) { return 100 * stage_us / stages.all_us; }

std::vector<Cell> stage_row(const scenes::Character& character, const SelfStages& stages) {
  return {character.name,
          static_cast<double>(character.asset.triangles.size()),
          stages.all_us,
          share(stages.open_us, stages),
          share(stages.triangle_boxes_us, stages),
          share(stages.descent_us, stages),
          share(stages.fans_us, stages),
          share(stages.cluster_pairs_us(), stages)};
}

/// The power of a column of `self_exponents`.
std::string power(const Table& exponents, const char* key) {
  return shown(exponents.rows[0][column_of(exponents, key)]);
}

std::string text_of_self_growth(const Table& growth, const Table& exponents) {
  const auto ratio = [&](const std::vector<Cell>& row) {
    return shown(row[column_of(growth, "of_boxes")]);
  };
  return "The time for all contacts grows with the power " + power(exponents, "self_us") +
         " of the number of triangles, that of skinning and boxes with " +
         power(exponents, "boxes_us") + ", and the first contact with " +
         power(exponents, "first_us") + ". All contacts take " + ratio(growth.rows.front()) +
         " times skinning and boxes for the smallest character, and " + ratio(growth.rows.back()) +
         " times for the largest.";
}

/// The generated creature, and the real characters that Pelt accepts.
Result<std::vector<scenes::Character>> staged_characters(const Conditions& conditions) {
  auto creature = scenes::generate_character(scenes::kCreature);
  if (!creature) return creature.error();
  std::vector<scenes::Character> all = {std::move(*creature)};
  if (conditions.models.empty()) return all;
  std::vector<std::filesystem::path> files = model_files(conditions.models);
  if (conditions.is_quick && files.size() > 2) files.resize(2);
  for (const std::filesystem::path& file : files)
    if (Result<scenes::Character> character = scenes::load_character(file))
      all.push_back(std::move(*character));
  return all;
}

Chart chart_of_growth(const Table& growth) {
  Chart chart;
  chart.id = "self_growth";
  chart.title = growth.title;
  chart.table = growth.id;
  chart.x = "triangles";
  chart.y = {"boxes_us", "self_us", "first_us"};
  chart.y_title = "time [us]";
  return chart;
}

}  // namespace

scenes::Scene lone_walker(const scenes::Character& character) {
  scenes::Scene scene;
  scene.name = character.name;
  scene.characters = {character};
  scenes::Instance instance;
  const auto& clips = character.asset.clips;
  const auto walk = std::find_if(clips.begin(), clips.end(),
                                 [](const asset::Clip& clip) { return clip.name == "walk"; });
  if (!clips.empty()) instance.clip = (walk == clips.end() ? clips.begin() : walk)->name;
  scene.instances = {instance};
  scene.frame_count = scenes::frames_of_longest_clip(scene);
  return scene;
}

Result<Table> self_growth(std::span<const std::uint32_t> triangles, const Conditions& conditions) {
  Table table = {"self_growth",
                 "Time of a character against itself, by number of triangles",
                 {{"triangles", "triangles"},
                  {"contacts", "contacts per frame"},
                  {"boxes_us", "skinning and boxes [us]"},
                  {"self_us", "all contacts [us]"},
                  {"first_us", "first contact [us]"},
                  {"of_boxes", "all contacts over skinning and boxes"},
                  {"node_pairs", "node pairs"},
                  {"triangle_pairs", "triangle pairs"},
                  {"filter_bytes", "filter [bytes per triangle]"},
                  {"filter_ms", "filter built in [ms]"}},
                 {},
                 "A walking creature of 56 joints, without filters; means over frames of its clip. "
                 "Brute force gives the same contacts. Frames without contact cost the same for "
                 "the first contact as for all."};
  for (const std::uint32_t count : triangles) {
    scenes::CreatureOptions options = scenes::kCreature;
    options.triangles = count;
    const Result<scenes::Character> character = scenes::generate_character(options);
    if (!character) return character.error();
    const auto figures = measure_against_itself(lone_walker(*character), kSelfFrames, conditions);
    if (!figures) return figures.error();
    table.rows.push_back(growth_row(count, *figures));
  }
  return table;
}

Table self_exponents(const Table& growth) {
  Table table = {"self_exponents",
                 "Times and contacts as powers of the number of triangles",
                 {},
                 {{}},
                 "The exponent b of a x^b, by least squares of the logarithms."};
  for (const char* key : {"contacts", "boxes_us", "self_us", "first_us"}) {
    const std::size_t x = column_of(growth, "triangles"), y = column_of(growth, key);
    std::vector<Measured> points;
    for (const std::vector<Cell>& row : growth.rows)
      points.push_back({*row[x].figure, *row[y].figure});
    const auto known = std::count_if(points.begin(), points.end(),
                                     [](const Measured& point) { return point.value > 0; });
    table.columns.push_back(growth.columns[y]);
    table.rows[0].push_back(known < 2 ? Cell() : Cell(fitted_exponent(points)));
  }
  return table;
}

Result<Table> self_stage_table(std::span<const scenes::Character> characters,
                               const Conditions& conditions) {
  Table table = {
      "self_stages",
      "How the time for all contacts splits",
      {{"character", "character"},
       {"triangles", "triangles"},
       {"all_us", "all contacts [us]"},
       {"open", "skinning and boxes [%]"},
       {"triangle_boxes", "boxes of triangles [%]"},
       {"descent", "descent [%]"},
       {"fans", "fans [%]"},
       {"cluster_pairs", "pairs of clusters [%]"}},
      {},
      "The clip \"walk\", or the first clip. Each stage is measured in a run of its own, "
      "without clocks in the library: the descent ends at overlapping clusters, and the "
      "time of fans (pairs that share a vertex) is the difference to a query without "
      "fans. Pairs of clusters are the rest: boxes of triangles are compared, and "
      "triangles tested."};
  for (const scenes::Character& character : characters) {
    const auto stages = measure_self_stages(lone_walker(character), kSelfFrames, conditions);
    if (!stages) return stages.error();
    table.rows.push_back(stage_row(character, *stages));
  }
  return table;
}

Result<Section> self_collision(const Conditions& conditions) {
  const std::span sizes(kSelfSizes);
  auto growth = self_growth(conditions.is_quick ? sizes.first(kQuickSizes) : sizes, conditions);
  if (!growth) return growth.error();
  const auto characters = staged_characters(conditions);
  if (!characters) return characters.error();
  auto stages = self_stage_table(*characters, conditions);
  if (!stages) return stages.error();
  Section section;
  Table exponents = self_exponents(*growth);
  section.text = {text_of_self_growth(*growth, exponents)};
  section.charts = {chart_of_growth(*growth)};
  section.tables = {std::move(*growth), std::move(exponents), std::move(*stages)};
  return section;
}

}  // namespace pelt::reproduce
