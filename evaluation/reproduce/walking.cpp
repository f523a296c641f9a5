/// The moving scenes of section 5: two men who walk towards each other (Figure 5), two creatures
/// who walk through each other (Figure 6), and a crowd of fifty (Figure 1).

#include "evaluation/reproduce/figures.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/scene_figures.hpp"

namespace pelt::reproduce {
namespace {

using tools::bench::Question;

constexpr std::array kWalking = {methods::kPaper, lab::kPaperEager, methods::kEager,
                                 methods::kOnDemand, lab::kRigid};

/// The methods that refit everything first.
constexpr std::array kEager = {lab::kPaperEager, methods::kEager};

/// The paper's figures for a scene.
struct Printed {
  std::optional<PrintedTimes> all, first;
};

std::vector<Comparison> comparisons(const Printed& printed) {
  std::vector<Comparison> all;
  for (const Question question : {Question::all, Question::first}) {
    const bool is_all = question == Question::all;
    all.push_back(
        {lab::kPaperEager, methods::kPaper, question, is_all ? printed.all : printed.first});
    all.push_back({lab::kPaperEager, methods::kOnDemand, question, {}});
    all.push_back({methods::kPaper, methods::kOnDemand, question, {}});
    all.push_back({methods::kEager, methods::kOnDemand, question, {}});
    all.push_back({methods::kOnDemand, lab::kRigid, question, {}});
  }
  return all;
}

std::string microseconds(double us) { return shown(us) + " us"; }

/// The paper's claim, compared with our figures, all of which are in the tables.
std::string text_of_claim(const tools::bench::SceneFigures& figures, const PrintedTimes& printed) {
  const double speed_up = mean_us(figures, lab::kPaperEager, Question::all) /
                          mean_us(figures, methods::kPaper, Question::all);
  return "In the paper, refitting on demand is " + shown(printed.slower_ms / printed.faster_ms) +
         " times as fast as refitting bottom-up. Here, the paper's method takes " +
         microseconds(mean_us(figures, methods::kPaper, Question::all)) + " per frame and is " +
         shown(speed_up) + " times as fast as refitting the same spheres bottom-up, which takes " +
         microseconds(mean_us(figures, lab::kPaperEager, Question::all)) + ".";
}

/// Why the paper's speed-up is not reached: the time of both methods before and in their queries.
std::string text_of_cause(const tools::bench::SceneFigures& figures) {
  const tools::bench::Figures& on_demand = figures_of(figures, "paper", Question::all);
  const tools::bench::Figures& bottom_up = figures_of(figures, "paper_eager", Question::all);
  const auto frames = static_cast<double>(figures.frames);
  const auto pairs = [&](const tools::bench::Figures& of) {
    return shown(static_cast<double>(of.answer.work.triangle_pairs) / frames);
  };
  const auto query = [](const tools::bench::Figures& of) {
    return microseconds(of.times.mean_us - of.times.mean_update_us);
  };
  return "Bottom-up spends " + microseconds(bottom_up.times.mean_update_us) +
         " on its update, which is most of its time if bodies are apart. Refitting on demand saves "
         "this time, but its query takes " +
         query(on_demand) + " instead of " + query(bottom_up) + ", because it contains " +
         shown(static_cast<double>(on_demand.answer.work.refits) / frames) +
         " refits, and its spheres leave " + pairs(on_demand) + " pairs of triangles instead of " +
         pairs(bottom_up) +
         ". Since 2005, bottom-up refitting has become faster by a larger factor than refitting on "
         "demand (see the section on the cost of a refit), so its share has shrunk.";
}

std::string text_of_ours(const tools::bench::SceneFigures& figures) {
  const double ours = mean_us(figures, methods::kOnDemand, Question::all);
  const double eager = mean_us(figures, methods::kEager, Question::all);
  return "Pelt takes " + microseconds(ours) + ", and " + microseconds(eager) +
         " if it refits everything first: on demand, it is " + shown(eager / ours) +
         " times as fast. Finding the first contact takes " +
         microseconds(mean_us(figures, methods::kOnDemand, Question::first)) + ".";
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
  const auto figures = measure_scene(*scene, kWalking, walk.most_frames, conditions);
  if (!figures) return figures.error();
  Result<Picture> picture = walk.picture(*scene, conditions);
  if (!picture) return picture.error();
  const std::string id = walk.id, title = walk.title;
  Section section;
  section.pictures.push_back(std::move(*picture));
  section.text = {text_of_claim(*figures, *walk.printed.all), text_of_cause(*figures),
                  text_of_ours(*figures)};
  section.tables = {
      comparison_table(id + "_ratios", title + ": speed-ups", *figures, comparisons(walk.printed)),
      method_table(id, title + ": a frame", *figures),
      eager_split_table(id + "_split", title + ": how the time of a frame splits", *figures,
                        kEager)};
  return section;
}

}  // namespace

Result<Section> two_men(const Conditions& conditions) {
  const Printed printed = {PrintedTimes{kPaperTwoMenBottomUp, kPaperTwoMenOnDemand}, {}};
  return measure_walk({"two_men", "Two men", approaching_scene(), printed, 60, refit_picture},
                      conditions);
}

Result<Section> worst_case(const Conditions& conditions) {
  const Printed printed = {PrintedTimes{kPaperWorstBottomUp, kPaperWorstOnDemand},
                           PrintedTimes{kPaperWorstFirstBottomUp, kPaperWorstFirstOnDemand}};
  return measure_walk(
      {"worst_case", "Two creatures", passing_through_scene(), printed, 60, passing_picture},
      conditions);
}

Result<Section> crowd_of_fifty(const Conditions& conditions) {
  const Printed printed = {PrintedTimes{kPaperCrowdBottomUp, kPaperCrowdOnDemand}, {}};
  return measure_walk({"crowd", "Fifty creatures", crowd_scene(), printed, 10, crowd_picture},
                      conditions);
}

}  // namespace pelt::reproduce
