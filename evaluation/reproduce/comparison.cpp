/// The comparison that the paper proposes in its last lines: trees refitted on demand and bottom-up
/// against rebuilt trees, spatial hashing and image space. All get the same joint palettes and find
/// the same contacts, except the images, which only answer yes or no. Skinning counts for the
/// methods that need skinned vertices, and is also shown separately.

#include "evaluation/reproduce/comparison.hpp"

#include "base/assert.hpp"
#include "evaluation/bench/bench.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/bench_scene.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

constexpr std::array kTreesOnDemand = {methods::kOnDemand, methods::kEager, methods::kPaper,
                                       lab::kBdTree};
constexpr std::array kSkinningAll = {methods::kOnDemand, lab::kPaperEager,  lab::kHybrid,
                                     lab::kAabbRefit,    lab::kAabbRebuild, lab::kHash,
                                     lab::kHashOverlap};

bool is_measured(const tools::bench::SceneFigures& figures, MethodKind method) {
  return std::any_of(figures.figures.begin(), figures.figures.end(),
                     [&](const tools::bench::Figures& of) { return of.method == method.name; });
}

Chart chart_of(const Table& table, const char* family, const char* title,
               std::span<const MethodKind> methods) {
  Chart chart;
  chart.id = table.id + "_" + family;
  chart.title = table.title + ": " + title;
  chart.table = table.id;
  chart.y_title = "per frame [us]";
  for (const MethodKind method : methods) chart.y.push_back(time_key(method));
  return chart;
}

}  // namespace

std::string time_key(MethodKind method) { return std::string(method.name) + "_us"; }

Column time_column(MethodKind method) { return {time_key(method), title_of(method) + " [us]"}; }

Table times_table(const std::string& id, const std::string& title, std::vector<Column> first,
                  std::span<const MethodKind> methods, const std::string& note) {
  Table table = {id, title, std::move(first), {}, note};
  for (const MethodKind method : methods) table.columns.push_back(time_column(method));
  table.columns.push_back({"fastest", "fastest"});
  return table;
}

void append_times(const tools::bench::SceneFigures& figures, tools::bench::Question question,
                  std::span<const MethodKind> methods, std::vector<Cell>& row) {
  std::optional<MethodKind> fastest;
  for (const MethodKind method : methods) {
    row.push_back(is_measured(figures, method) ? mean_us(figures, method, question) : Cell());
    if (!row.back().figure) continue;
    if (!fastest || *row.back().figure < mean_us(figures, *fastest, question)) fastest = method;
  }
  PELT_ASSERT(fastest);
  row.push_back(title_of(*fastest));
}

std::string how_measured(const std::string& mean_of, const Conditions& conditions) {
  return mean_of + (mean_of.empty() ? "" : " ") + "Medians of " +
         std::to_string(conditions.is_quick ? 3 : 9) +
         " repetitions; one thread, hot caches; skinning is included.";
}

void add_with_charts(Table table, const std::string& x, Axes axes, std::optional<double> x_end,
                     Section& section) {
  for (Chart chart : {chart_of(table, "on_demand", "trees on demand", kTreesOnDemand),
                      chart_of(table, "skinning_all", "methods that skin all", kSkinningAll)}) {
    chart.x = x;
    chart.axes = axes;
    chart.x_end = x_end;
    section.charts.push_back(std::move(chart));
  }
  section.tables.push_back(std::move(table));
}

std::optional<std::size_t> heap_bytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  return std::nullopt;
#endif
}

namespace {

// Compares the answers of all methods of the comparison.

struct Asked {
  std::string title;
  tools::bench::BenchMethod method;
  double missing = 0, extra = 0;
};

std::vector<Asked> all_methods() {
  std::vector<Asked> all;
  for (const MethodKind method : kCompared)
    all.push_back({title_of(method), tools::bench::method_of(method)});
  all.push_back({title_of(lab::kHash) + " in one grid",
                 lab::rival_method("hash_crowd", [] { return rivals::make_hash_crowd(); })});
  return all;
}

/// Number of contacts of `a` that are not in `b`. Both are in ascending order, as for the contacts
/// of one pair.
double without(std::span<const Contact> a, std::span<const Contact> b) {
  std::vector<Contact> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return static_cast<double>(rest.size());
}

Result<std::vector<Contact>> contacts_of(const tools::bench::BenchMethod& method,
                                         std::span<const tools::scene::Collider> colliders,
                                         const tools::scene::Palettes& palettes) {
  tools::bench::Runner runner(colliders, method);
  if (const auto posed = runner.pose(palettes); !posed) return posed.error();
  runner.ask(Question::all);
  return runner.found().contacts;
}

/// Adds the differences between the answers about one pair. Returns the number of contacts of brute
/// force.
Result<double> compare(const scenes::Scene& scene, std::vector<Asked>& methods) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(scene, 0, scratch, palettes);
  const auto exact = contacts_of(tools::bench::method_of(methods::kBrute), *colliders, palettes);
  if (!exact) return exact.error();
  for (Asked& asked : methods) {
    const auto found = contacts_of(asked.method, *colliders, palettes);
    if (!found) return found.error();
    asked.missing += without(*exact, *found);
    asked.extra += without(*found, *exact);
  }
  return static_cast<double>(exact->size());
}

}  // namespace

Result<Table> agreement(const scenes::Character& creature, const Conditions& conditions) {
  std::vector<double> distances = {0.9, 0.8, kTouching, 0.6, 0.45, kDeep, 0.15, 0.0};
  if (conditions.is_quick) distances = {kTouching, kDeep};
  std::vector<Asked> methods = all_methods();
  double contacts = 0;
  for (const double at : distances) {
    const auto found = compare(facing_pair(creature, at), methods);
    if (!found) return found.error();
    contacts += *found;
  }
  Table table = {
      "agreement",
      "Differences between the contacts of each method and those of brute force",
      {{"method", "method"}, {"contacts", "contacts"}, {"missing", "missing"}, {"extra", "extra"}},
      {},
      "For two creatures; sums over " + std::to_string(distances.size()) +
          " distances. The other tables are not written either if two methods give different "
          "answers."};
  for (const Asked& asked : methods)
    table.rows.push_back({asked.title, contacts, asked.missing, asked.extra});
  return table;
}

namespace {

// The comparison over a clip: caches, slow frames, memory.

constexpr std::uint32_t kClipFrames = 30;

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
  const std::uint32_t frames = conditions.is_quick ? kClipFrames / 5 : kClipFrames;
  settings.frames = tools::arguments::FrameRange{0, scene.frame_count, scene.frame_count / frames};
  std::ostringstream errors;
  return agreed(tools::bench::bench_scene(scene, settings, errors), errors);
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

namespace {

Result<void> measure_all(const scenes::Character& creature, const Conditions& conditions,
                         Section& section) {
  if (const auto done = add_separation(creature, conditions, section); !done) return done;
  if (const auto done = add_resolution(conditions, section); !done) return done;
  if (const auto done = add_instances(creature, conditions, section); !done) return done;
  if (const auto done = add_image_space(creature, conditions, section); !done) return done;
  for (const auto& measure : {time_split, cell_sizes, leaf_sizes, agreement}) {
    auto table = measure(creature, conditions);
    if (!table) return table.error();
    section.tables.push_back(std::move(*table));
  }
  auto clip = clip_table(conditions);
  if (!clip) return clip.error();
  section.tables.push_back(std::move(*clip));
  return {};
}

}  // namespace

Result<Section> comparison(const Conditions& conditions) {
  const auto creature = scenes::generate_character(scenes::kCreature);
  if (!creature) return creature.error();
  Section section;
  if (const auto done = measure_all(*creature, conditions, section); !done) return done.error();
  section.text = {
      "Every method gets the same joint palettes and finds the same contacts, which are compared "
      "before any time is measured. The skinning that a method needs counts as its time. All use "
      "the same exact test of triangles, eight at a time, so the comparison is about finding "
      "pairs. All times are for one thread."};
  for (std::string& answer : answers_of(section)) section.text.push_back(std::move(answer));
  return section;
}

}  // namespace pelt::reproduce
