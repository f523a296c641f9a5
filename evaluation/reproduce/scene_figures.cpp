#include "evaluation/reproduce/scene_figures.hpp"

#include "base/assert.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>

namespace pelt::reproduce {

using methods::MethodKind;
using tools::bench::Figures;
using tools::bench::Question;
using tools::bench::SceneFigures;

scenes::Scene facing_pair(const scenes::Character& character, double distance,
                          std::uint32_t phases) {
  scenes::Scene scene;
  scene.name = "two of " + character.name;
  scene.characters = {character};
  scene.frame_count = phases;
  if (const asset::Clip* walk = character.asset.find_clip("walk"); walk && walk->duration > 0)
    scene.fps = phases / static_cast<double>(walk->duration);
  scenes::Instance left, right;
  left.clip = right.clip = "walk";
  left.start = 0.2;
  right.start = 0.65;
  left.translation = {0, 0, -distance / 2};
  right.translation = {0, 0, distance / 2};
  right.rotation = {0, 1, 0, 0};
  scene.instances = {left, right};
  return scene;
}

scenes::Scene closing_pair(const scenes::Character& character, double from, double to,
                           std::uint32_t frames) {
  scenes::Scene scene = facing_pair(character, from, frames);
  const double seconds = (frames - 1) / scene.fps;
  scene.instances[0].velocity = {0, 0, (from - to) / 2 / seconds};
  scene.instances[1].velocity = {0, 0, (to - from) / 2 / seconds};
  return scene;
}

namespace {

struct Words {
  MethodKind method;
  const char *title, *description;
};

constexpr Words kWords[] = {
    {methods::kOnDemand, "Pelt",
     "the library: a tree of boxes with up to eight slots per node; vertices are skinned and boxes "
     "computed only in nodes that a query visits"},
    {methods::kEager, "Pelt eager",
     "the same tree and query, with all vertices skinned and all boxes computed bottom-up first: "
     "our fastest method that refits everything"},
    {lab::kRigid, "Pelt rigid",
     "the same tree and query, with the tree built over the posed mesh, which is not timed: the "
     "cost of a query between rigid bodies"},
    {methods::kPaper, "paper on demand",
     "Kavan & Zara 2005: a tree of spheres, refitted on demand with the optimised bound"},
    {lab::kPaperEq2, "paper eq. 2", "the same with the bound of their equation 2"},
    {lab::kPaperEager, "paper bottom-up",
     "the method that the paper compares with: all vertices skinned, the same tree refitted "
     "bottom-up"},
    {lab::kPaperRigid, "paper rigid",
     "a tree of spheres built over the posed mesh, which is not timed"},
    {lab::kAabbRefit, "AABB refit",
     "van den Bergen 1997: all vertices skinned, a binary tree of boxes refitted bottom-up"},
    {lab::kAabbRebuild, "AABB rebuild", "the same tree, built again for every pose"},
    {lab::kHybrid, "AABB hybrid",
     "Larsson & Akenine-Moller 2001: all vertices skinned, the upper half of that tree "
     "refitted, the lower half only where a query visits it"},
    {lab::kHash, "hash",
     "Teschner et al. 2003: all vertices skinned, all triangles hashed into the cells of a grid"},
    {lab::kHashOverlap, "hash in overlap",
     "the same, only for triangles in the overlap of the two bodies' boxes, with sorted cells"},
    {lab::kBdTree, "BD-tree",
     "James & Pai 2004: spheres refitted on demand from the entries of the joint "
     "matrices, as a reduced model"},
    {methods::kBrute, "brute force", "every triangle of one against every triangle of the other"},
};

const Words& words_of(MethodKind method) {
  for (const Words& words : kWords)
    if (words.method == method) return words;
  PELT_ASSERT(false);
  return kWords[0];
}

}  // namespace

std::string title_of(MethodKind method) { return words_of(method).title; }
std::string description_of(MethodKind method) { return words_of(method).description; }

namespace {

std::vector<Cell> method_row(const SceneFigures& scene, const Figures& all) {
  const Figures& first = figures_of(scene, all.method, Question::first);
  const auto frames = static_cast<double>(scene.frames);
  const auto each = [&](std::uint64_t count) { return static_cast<double>(count) / frames; };
  const QueryStats& work = all.answer.work;
  const auto method = methods::find_method(lab::kLabMethods, all.method);
  return {method ? title_of(*method) : all.method,
          all.times.mean_us,
          all.times.mean_update_us,
          all.times.mean_query_us(),
          all.times.mean_contact_us,
          first.times.mean_us,
          each(work.node_pairs),
          each(work.refits),
          each(work.posed_vertices),
          each(work.triangle_pairs)};
}

std::string summary(const SceneFigures& scene) {
  return text::counted(scene.frames, "frame") + ", " +
         std::to_string(scene.figures[0].answer.frames_in_contact) + " of them in contact, with " +
         shown(contact_count(scene)) + " contacts per frame on average; " +
         text::with_commas(scene.triangles) + " triangles. Skinning all vertices takes " +
         shown(scene.skinning.mean_us) + " us per frame. Medians of " +
         std::to_string(scene.repetitions) +
         " repetitions, means over the frames, one thread, caches hot; all methods give the same "
         "contacts. \"Update\" is the part before the queries; rigid methods have none. Pelt's "
         "trees store a vertex once for each node that needs it, so Pelt eager skins more vertices "
         "than the models have.";
}

/// At most `most` frames, evenly spaced.
tools::arguments::FrameRange frames_of(const scenes::Scene& scene, std::uint32_t most) {
  return {0, scene.frame_count, (scene.frame_count + most - 1) / most};
}

Result<SceneFigures> measure(const scenes::Scene& scene, tools::bench::BenchSettings settings,
                             std::uint32_t most_frames, const Conditions& conditions) {
  settings.program = "pelt-lab";
  settings.questions = {Question::all, Question::first};
  settings.repetitions = conditions.is_quick ? 3 : 9;
  settings.frames =
      frames_of(scene, conditions.is_quick ? std::max(most_frames / 4, 1u) : most_frames);
  std::ostringstream errors;
  return agreed(tools::bench::bench_scene(scene, settings, errors), errors);
}

}  // namespace

const Figures& figures_of(const SceneFigures& scene, std::string_view method, Question question) {
  const auto found =
      std::find_if(scene.figures.begin(), scene.figures.end(), [&](const Figures& figures) {
        return figures.method == method && figures.question == question;
      });
  PELT_ASSERT(found != scene.figures.end());
  return *found;
}

Result<SceneFigures> measure_scene(const scenes::Scene& scene, std::span<const MethodKind> methods,
                                   std::uint32_t most_frames, const Conditions& conditions) {
  std::vector<tools::bench::BenchMethod> measured;
  for (const MethodKind method : methods) measured.push_back(tools::bench::method_of(method));
  return measure_scene(scene, std::move(measured), most_frames, conditions);
}

Result<SceneFigures> measure_scene(const scenes::Scene& scene,
                                   std::vector<tools::bench::BenchMethod> methods,
                                   std::uint32_t most_frames, const Conditions& conditions) {
  tools::bench::BenchSettings settings;
  settings.methods = std::move(methods);
  return measure(scene, std::move(settings), most_frames, conditions);
}

Result<SceneFigures> measure_against_itself(const scenes::Scene& scene, std::uint32_t most_frames,
                                            const Conditions& conditions) {
  tools::bench::BenchSettings settings;
  settings.methods = {tools::bench::self_method(methods::kBoxes),
                      tools::bench::self_method(methods::kSelf)};
  settings.is_self = true;
  return measure(scene, std::move(settings), most_frames, conditions);
}

double mean_us(const SceneFigures& figures, MethodKind method, Question question) {
  return figures_of(figures, method.name, question).times.mean_us;
}

double contact_count(const SceneFigures& figures) {
  const Figures& all = figures_of(figures, figures.figures[0].method, Question::all);
  return static_cast<double>(all.answer.contacts) / static_cast<double>(figures.frames);
}

Table method_table(const std::string& id, const std::string& title, const SceneFigures& figures) {
  Table table = {id,
                 title,
                 {{"method", "method"},
                  {"all_us", "all contacts [us]"},
                  {"update_us", "of that, update [us]"},
                  {"query_us", "query [us]"},
                  {"contact_us", "frames in contact [us]"},
                  {"first_us", "first contact [us]"},
                  {"node_pairs", "node pairs"},
                  {"refits", "refits"},
                  {"posed_vertices", "vertices skinned"},
                  {"triangle_pairs", "triangle pairs"}},
                 {},
                 summary(figures)};
  for (const Figures& method : figures.figures)
    if (method.question == Question::all) table.rows.push_back(method_row(figures, method));
  return table;
}

Table eager_split_table(const std::string& id, const std::string& title,
                        const SceneFigures& figures, std::span<const MethodKind> methods) {
  Table table = {
      id,
      title,
      {{"method", "method"},
       {"skinning_us", "skinning [us]"},
       {"refit_us", "refit [us]"},
       {"query_us", "query [us]"},
       {"all_us", "all [us]"},
       {"skinning_percent", "skinning [%]"},
       {"refit_percent", "refit [%]"},
       {"query_percent", "query [%]"}},
      {},
      "All contacts. Skinning is the time for all vertices alone; refit is the rest of the "
      "update."};
  const double skinning = figures.skinning.mean_us;
  for (const MethodKind method : methods) {
    const tools::bench::Times& times = figures_of(figures, method.name, Question::all).times;
    const double refit = times.mean_update_us - skinning;
    const double query = times.mean_query_us(), percent = 100 / times.mean_us;
    table.rows.push_back({title_of(method), skinning, refit, query, times.mean_us,
                          percent * skinning, percent * refit, percent * query});
  }
  return table;
}

namespace {

std::vector<Cell> comparison_row(const SceneFigures& figures, const Comparison& c) {
  const tools::bench::Times& slower = figures_of(figures, c.slower.name, c.question).times;
  const tools::bench::Times& faster = figures_of(figures, c.faster.name, c.question).times;
  std::vector<Cell> row = {title_of(c.faster), title_of(c.slower),
                           c.question == Question::all ? "all contacts" : "first contact",
                           slower.mean_us / faster.mean_us,
                           faster.frames_in_contact > 0
                               ? Cell(slower.mean_contact_us / faster.mean_contact_us)
                               : Cell()};
  if (c.printed)
    for (const double figure :
         {c.printed->slower_ms / c.printed->faster_ms, c.printed->faster_ms, c.printed->slower_ms})
      row.push_back(figure);
  row.resize(8);
  return row;
}

}  // namespace

Table comparison_table(const std::string& id, const std::string& title, const SceneFigures& figures,
                       std::span<const Comparison> comparisons) {
  Table table = {
      id,
      title,
      {{"faster", "method"},
       {"slower", "against"},
       {"question", "question"},
       {"speed_up", "speed-up here"},
       {"contact_speed_up", "in frames with contact"},
       {"paper_speed_up", "in the paper"},
       {"paper_ms", "method, in the paper [ms]"},
       {"paper_against_ms", "the other, in the paper [ms]"}},
      {},
      "Speed-up: the time of the method under \"against\" divided by that of the first method; "
      "below 1, the first method is slower. The paper does not say how many of its frames have "
      "contacts."};
  for (const Comparison& c : comparisons) table.rows.push_back(comparison_row(figures, c));
  return table;
}

}  // namespace pelt::reproduce
