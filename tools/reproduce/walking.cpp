/// The moving scenes of section 5: two men who walk towards each other (Figure 5), two creatures
/// who walk through each other (Figure 6), and a crowd of fifty (Figure 1).

#include "tools/reproduce/figures.hpp"
#include "tools/reproduce/paper_figures.hpp"
#include "tools/reproduce/scene_figures.hpp"
#include "tools/reproduce/scene_texts.hpp"

namespace pelt::reproduce {
namespace {

using bench::MethodKind;
using tools::Question;

constexpr std::array kMethods = {MethodKind::paper, MethodKind::paper_eager, MethodKind::eager,
                                 MethodKind::on_demand, MethodKind::rigid};

/// What the paper prints of a scene: how many times faster on demand is than bottom-up.
struct Printed {
  std::optional<double> all, first;
};

std::vector<Comparison> comparisons(const Printed& printed) {
  std::vector<Comparison> all;
  for (const Question question : {Question::all, Question::first}) {
    const bool is_all = question == Question::all;
    all.push_back({MethodKind::paper_eager, MethodKind::paper, question,
                   is_all ? printed.all : printed.first});
    all.push_back({MethodKind::paper_eager, MethodKind::on_demand, question, {}});
    all.push_back({MethodKind::paper, MethodKind::on_demand, question, {}});
    all.push_back({MethodKind::eager, MethodKind::on_demand, question, {}});
    all.push_back({MethodKind::on_demand, MethodKind::rigid, question, {}});
  }
  return all;
}

/// All figures are in the tables.
std::string why_ratios_differ(const tools::SceneFigures& figures) {
  const double bottom_up = mean_us(figures, MethodKind::paper_eager, Question::all);
  const double on_demand = mean_us(figures, MethodKind::paper, Question::all);
  return "The paper's method takes " + shown(on_demand) + " us a frame, refitted bottom-up " +
         shown(bottom_up) +
         " us. Where the second is a smaller multiple of the first than in the "
         "paper, it is because bottom-up refit goes through memory in order, four leaves at a "
         "time, "
         "and gained more from twenty years of processors than a descent that goes where it has "
         "to. "
         "Pelt's engine takes " +
         shown(mean_us(figures, MethodKind::on_demand, Question::all)) +
         " us, our tuned eager one " + shown(mean_us(figures, MethodKind::eager, Question::all)) +
         " us.";
}

struct Walk {
  const char *id, *title;
  std::string_view scene;
  Printed printed;
  std::uint32_t most_frames;
  Result<Picture> (*picture)(const scenes::Scene&, const Conditions&);
};

Result<Section> measure_walk(const Walk& walk, const Conditions& conditions) {
  const Result<scenes::Scene> scene = scenes::parse_scene(walk.scene, {});
  if (!scene) return scene.error();
  const auto figures = measure_scene(*scene, kMethods, walk.most_frames, conditions);
  if (!figures) return figures.error();
  Result<Picture> picture = walk.picture(*scene, conditions);
  if (!picture) return picture.error();
  const std::string id = walk.id, title = walk.title;
  Section section;
  section.pictures.push_back(std::move(*picture));
  section.text = {why_ratios_differ(*figures)};
  section.tables = {comparison_table(id + "_ratios", title + ": how many times faster", *figures,
                                     comparisons(walk.printed)),
                    method_table(id, title + ": a frame", *figures)};
  return section;
}

}  // namespace

Result<Section> two_men(const Conditions& conditions) {
  const Printed printed = {kPaperTwoMenBottomUp / kPaperTwoMenOnDemand, {}};
  return measure_walk({"two_men", "Two men", approaching_scene(), printed, 60, refit_picture},
                      conditions);
}

Result<Section> worst_case(const Conditions& conditions) {
  const Printed printed = {kPaperWorstBottomUp / kPaperWorstOnDemand,
                           kPaperWorstFirstBottomUp / kPaperWorstFirstOnDemand};
  return measure_walk(
      {"worst_case", "Two creatures", passing_through_scene(), printed, 60, passing_picture},
      conditions);
}

Result<Section> crowd_of_fifty(const Conditions& conditions) {
  const Printed printed = {kPaperCrowdSpeedUp, {}};
  return measure_walk({"crowd", "Fifty creatures", crowd_scene(), printed, 10, crowd_picture},
                      conditions);
}

}  // namespace pelt::reproduce
