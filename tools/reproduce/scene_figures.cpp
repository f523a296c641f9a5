#include "tools/reproduce/scene_figures.hpp"

#include "base/assert.hpp"
#include "tools/pelt/bench_scene.hpp"
#include "tools/pelt/text.hpp"

#include <algorithm>
#include <sstream>

namespace pelt::reproduce {
namespace {

using bench::MethodKind;
using tools::Figures;
using tools::Question;
using tools::SceneFigures;

std::vector<Cell> method_row(const SceneFigures& scene, const Figures& all) {
  const Figures& first = figures_of(scene, all.engine, Question::first);
  const auto frames = static_cast<double>(scene.frames);
  const auto each = [&](std::uint64_t count) { return static_cast<double>(count) / frames; };
  const QueryStats& work = all.answer.work;
  return {all.engine,
          all.times.mean_us,
          all.times.mean_update_us,
          all.times.mean_contact_us,
          first.times.mean_us,
          each(work.node_pairs),
          each(work.refits),
          each(work.posed_vertices),
          each(work.triangle_pairs)};
}

std::string summary(const SceneFigures& scene) {
  return tools::counted(scene.frames, "frame") + ", " +
         std::to_string(scene.figures[0].answer.frames_in_contact) + " of them in contact; " +
         tools::with_commas(scene.triangles) + " triangles. All vertices skinned take " +
         shown(scene.skinning.mean_us) + " us a frame. Medians of " +
         std::to_string(scene.repetitions) +
         " repetitions, means over the frames; all methods give the same contacts. \"Update\" is "
         "the part before the queries; rigid has none, for rigid bodies need none.";
}

/// At most so many, evenly over all.
tools::FrameRange frames_of(const scenes::Scene& scene, std::uint32_t most) {
  return {0, scene.frame_count, (scene.frame_count + most - 1) / most};
}

}  // namespace

const Figures& figures_of(const SceneFigures& scene, std::string_view method, Question question) {
  const auto found =
      std::find_if(scene.figures.begin(), scene.figures.end(), [&](const Figures& figures) {
        return figures.engine == method && figures.variant.question == question;
      });
  PELT_ASSERT(found != scene.figures.end());
  return *found;
}

Result<SceneFigures> measure_scene(const scenes::Scene& scene, std::span<const MethodKind> methods,
                                   std::uint32_t most_frames, const Conditions& conditions) {
  std::vector<tools::Engine> engines;
  for (const MethodKind method : methods) engines.push_back(tools::engine_of(method));
  return measure_scene(scene, std::move(engines), most_frames, conditions);
}

Result<SceneFigures> measure_scene(const scenes::Scene& scene, std::vector<tools::Engine> engines,
                                   std::uint32_t most_frames, const Conditions& conditions) {
  tools::BenchSettings settings;
  settings.engines = std::move(engines);
  settings.questions = {Question::all, Question::first};
  settings.caches = {tools::Cache::hot};
  settings.repetitions = conditions.is_quick ? 3 : 9;
  settings.frames =
      frames_of(scene, conditions.is_quick ? std::max(most_frames / 4, 1u) : most_frames);
  std::vector<SceneFigures> figures;
  std::ostringstream errors;
  const auto exit = tools::bench_scene(scene, settings, figures, errors);
  if (!exit) return exit.error();
  if (figures.empty()) return Error{ErrorCode::invalid_argument, errors.str()};
  return std::move(figures[0]);
}

double mean_us(const SceneFigures& figures, MethodKind method, Question question) {
  return figures_of(figures, bench::name_of(method), question).times.mean_us;
}

double contact_count(const SceneFigures& figures) {
  const Figures& all = figures_of(figures, figures.figures[0].engine, Question::all);
  return static_cast<double>(all.answer.contacts) / static_cast<double>(figures.frames);
}

Table method_table(const std::string& id, const std::string& title, const SceneFigures& figures) {
  Table table = {id,
                 title,
                 {{"method", "method"},
                  {"all_us", "all contacts [us]"},
                  {"update_us", "of that, update [us]"},
                  {"contact_us", "frames in contact [us]"},
                  {"first_us", "first contact [us]"},
                  {"node_pairs", "node pairs"},
                  {"refits", "refits"},
                  {"posed_vertices", "vertices skinned"},
                  {"triangle_pairs", "triangle pairs"}},
                 {},
                 summary(figures)};
  for (const Figures& method : figures.figures)
    if (method.variant.question == Question::all) table.rows.push_back(method_row(figures, method));
  return table;
}

Table comparison_table(const std::string& id, const std::string& title, const SceneFigures& figures,
                       std::span<const Comparison> comparisons) {
  Table table = {id,
                 title,
                 {{"comparison", "times faster"},
                  {"question", "contacts"},
                  {"ratio", "here"},
                  {"paper_ratio", "in the paper"}},
                 {},
                 ""};
  for (const Comparison& c : comparisons) {
    const double ratio =
        mean_us(figures, c.slower, c.question) / mean_us(figures, c.faster, c.question);
    table.rows.push_back(
        {std::string(bench::name_of(c.faster)) + " than " + std::string(bench::name_of(c.slower)),
         c.question == Question::all ? "all" : "first", ratio, c.printed ? *c.printed : Cell()});
  }
  return table;
}

}  // namespace pelt::reproduce
