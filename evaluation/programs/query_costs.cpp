/// Measures queries of one or two posed characters, including posing: on demand, with the same
/// trees skinned and opened completely, and by other means of answering the same query (Embree if
/// it is built in, a height field as a static mesh).
///
/// Each frame is queried in all ways in turn. Times are medians over the frames; each frame's time
/// is the best of several runs. Nothing is printed for a query if two ways give different answers,
/// except for Embree, which is not exact: the program counts its errors above a 10,000th.

#include "evaluation/programs/program.hpp"
#include "evaluation/programs/query_stage.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <pelt/inside.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#ifdef PELT_BENCH_PEERS
#include "evaluation/peers/embree_mesh.hpp"
#endif

namespace pelt::programs {
namespace {

using tools::output::median;

struct Arguments {
  std::uint32_t frames = 12, points = 1000, runs = 5;
};

/// Numbers that must be equal for both ways.
using Answer = std::vector<double>;

/// Sets the palettes of a frame and runs the query.
struct Way {
  std::string name;
  std::function<void(const QueryFrame&, Answer&)> ask;
  bool is_exact = true;
};

/// The first way is ours.
struct Question {
  std::string name;
  std::vector<Way> ways;
};

/// One run over the frames: fills `answers`, and lowers the times to the least ones.
void run(const Way& way, const std::vector<QueryFrame>& frames, std::vector<Answer>& answers,
         std::vector<double>& times) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    answers[i].clear();
    times[i] = std::min(times[i], microseconds([&] { way.ask(frames[i], answers[i]); }));
  }
}

/// Counts numbers that differ by more than a 10,000th.
std::size_t count_wrong(const std::vector<Answer>& expected, const std::vector<Answer>& found) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    for (std::size_t k = 0; k < expected[i].size(); ++k)
      wrong += !(std::fabs(expected[i][k] - found[i][k]) <= 1e-4 * std::fabs(expected[i][k]));
  return wrong;
}

void measure(const Question& question, const QueryStage& stage, std::uint32_t runs) {
  const std::size_t frames = stage.frames().size();
  std::vector<std::vector<Answer>> answers(question.ways.size(), std::vector<Answer>(frames));
  std::vector<std::vector<double>> times(question.ways.size(),
                                         std::vector<double>(frames, HUGE_VAL));
  for (std::uint32_t r = 0; r < runs; ++r)
    for (std::size_t w = 0; w < question.ways.size(); ++w)
      run(question.ways[w], stage.frames(), answers[w], times[w]);
  for (std::size_t w = 1; w < question.ways.size(); ++w)
    if (question.ways[w].is_exact && answers[w] != answers[0])
      return void(std::printf("  %-28s the answers differ\n", question.name.c_str()));

  const double ours = median(times[0]);
  std::printf("  %-28s %9.1f us", question.name.c_str(), ours);
  for (std::size_t w = 1; w < question.ways.size(); ++w) {
    const Way& way = question.ways[w];
    std::printf("; %s %.1f us, %.2fx", way.name.c_str(), median(times[w]), median(times[w]) / ours);
    if (!way.is_exact) std::printf(", %zu wrong", count_wrong(answers[0], answers[w]));
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Two instances and the queries to measure.
class Costs {
 public:
  Costs(const scenes::Character& character, const SkinnedModel& model, const Arguments& arguments)
      : asset_(character.asset),
        arguments_(arguments),
        stage_(character.asset, model, arguments.frames, arguments.points),
        a_(model),
        b_(model) {}

  void measure_all() {
    std::printf("%zu triangles, %s surface\n", asset_.triangles.size(),
                a_.model().surface().is_closed() ? "closed" : "open");
    measure_points();
    measure_pairs();
    if (a_.model().surface().is_closed()) measure_insides();
    measure_terrain();
  }

 private:
  using AskOne = std::function<void(const QueryFrame&, Answer&)>;

  /// A query of the first instance.
  Question about_one(const std::string& name, const AskOne& ask) {
    return about(name, nullptr, ask);
  }

  /// A query of both; the palette of the second instance is a member of the frame.
  Question about(const std::string& name, JointPalette QueryFrame::*second, const AskOne& ask) {
    const auto way = [=, this](bool opens_all) {
      return [=, this](const QueryFrame& frame, Answer& answer) {
        pose(a_, frame.a, opens_all);
        if (second) pose(b_, frame.*second, opens_all);
        ask(frame, answer);
      };
    };
    return {name, {{"on demand", way(false)}, {"all opened", way(true)}}};
  }

  static void pose(Pose& pose, const JointPalette& palette, bool opens_all) {
    (void)pose.set_palette(palette);
    if (opens_all) open_all(pose);
  }

  void measure(const Question& question) { programs::measure(question, stage_, arguments_.runs); }

  void measure_points() {
    for (const std::size_t count : {std::size_t{1}, std::size_t{arguments_.points}}) {
      Question question =
          about_one(std::to_string(count) + " closest point(s)",
                    [=, this](const QueryFrame& f, Answer& answer) {
                      closest_.resize(count);
                      closest_points(a_, std::span(f.points).first(count), scratch_, closest_);
                      for (const ClosestPoint& n : closest_) answer.push_back(n.distance);
                    });
      add_embree(question, count);
      measure(question);
    }
  }

#ifdef PELT_BENCH_PEERS
  void add_embree(Question& question, std::size_t count) {
    const auto mesh =
        std::make_shared<peers::EmbreeMesh>(asset_.triangles, a_.model().vertex_count());
    const auto ask = [=, this](const QueryFrame& frame, Answer& answer) {
      (void)a_.set_palette(frame.a);
      posed_vertices(a_, mesh->positions());
      mesh->refit();
      closest_.resize(count);
      mesh->find_closest(std::span(frame.points).first(count), closest_);
      for (const ClosestPoint& n : closest_) answer.push_back(n.distance);
    };
    question.ways.push_back({"Embree", ask, false});
  }
#else
  void add_embree(Question&, std::size_t) {}
#endif

  void measure_pairs() {
    const double reach = 0.05 * stage_.metre();
    const auto all_within = [=, this](const QueryFrame&, Answer& answer) {
      near_.clear();
      clearance(a_, b_, reach, scratch_, near_);
      add_pairs(near_, answer);
    };
    const auto any_within = [=, this](const QueryFrame&, Answer& answer) {
      answer.push_back(is_within(a_, b_, reach, scratch_).answer);
    };
    measure(about("clearance 5 cm, 3 cm apart", &QueryFrame::near, all_within));
    measure(about("clearance 5 cm, touching", &QueryFrame::touching, all_within));
    measure(about("within 5 cm, 1 m apart", &QueryFrame::far, any_within));
    measure(about("within 5 cm, 3 cm apart", &QueryFrame::near, any_within));
    measure(about("within 5 cm, touching", &QueryFrame::touching, any_within));
    measure(about("contacts", &QueryFrame::touching,
                  [this](const QueryFrame&, Answer& answer) { find_contacts(answer); }));
    measure(about("contacts, their geometry", &QueryFrame::touching,
                  [this](const QueryFrame&, Answer& answer) {
                    find_contacts(answer);
                    describe_contacts(a_, b_, contacts_, scratch_, geometry_);
                    for (const ContactPatch& patch : geometry_.patches)
                      answer.insert(answer.end(), {patch.length, patch.depth, patch.point.x});
                    answer.push_back(static_cast<double>(geometry_.curves.size()));
                  }));
  }

  void find_contacts(Answer& answer) {
    contacts_.clear();
    collide(a_, b_, scratch_, contacts_);
    add_pairs(contacts_, answer);
  }

  /// The number of pairs and a sum that depends on their order, because there may be millions.
  template <typename Pair>
  static void add_pairs(const std::vector<Pair>& pairs, Answer& answer) {
    std::uint64_t sum = 0;
    for (const Pair& p : pairs) sum = sum * 31 + p.triangle_a * 7919u + p.triangle_b;
    answer.push_back(static_cast<double>(pairs.size()));
    answer.push_back(static_cast<double>(sum >> 12));
  }

  void measure_insides() {
    measure(about("deepest vertex, touching", &QueryFrame::touching,
                  [this](const QueryFrame&, Answer& answer) {
                    Penetration deepest;
                    deepest_vertex(a_, b_, scratch_, deepest);
                    answer.insert(answer.end(), {1.0 * deepest.vertex, deepest.depth});
                  }));
    measure(about("volume", nullptr, [this](const QueryFrame&, Answer& answer) {
      Volume found;
      volume(a_, found);
      answer.insert(answer.end(), {found.value, found.error});
    }));
    measure(about("intersection volume, touching", &QueryFrame::touching,
                  [this](const QueryFrame&, Answer& answer) {
                    Volume found;
                    intersection_volume(a_, b_, scratch_, found);
                    answer.insert(answer.end(), {found.value, found.error});
                  }));
    for (const std::size_t count : {std::size_t{1}, std::size_t{100}})
      measure(about_one("side of " + std::to_string(count) + " point(s)",
                        [=, this](const QueryFrame& frame, Answer& answer) {
                          for (const Vec3& p : std::span(frame.points).first(count)) {
                            PointSide side = PointSide::outside;
                            side_of(a_, p, scratch_, side);
                            answer.push_back(static_cast<double>(side));
                          }
                        }));
  }

  void measure_terrain() {
    const HeightField small = stage_.hills(256), large = stage_.hills(4096);
    Pose mesh(as_static_mesh(small));
    const auto on = [this](const HeightField& field) {
      return [&field, this](const QueryFrame&, Answer& answer) {
        contacts_.clear();
        collide(a_, field, scratch_, contacts_);
        add_pairs(contacts_, answer);
      };
    };
    Question question = about_one("height field, 256 x 256", on(small));
    question.ways.push_back({"as a static mesh", [&](const QueryFrame& frame, Answer& answer) {
                               pose(a_, frame.a, false);
                               contacts_.clear();
                               collide(a_, mesh, scratch_, contacts_);
                               add_pairs(contacts_, answer);
                             }});
    measure(question);
    measure(about_one("height field, 4096 x 4096", on(large)));
  }

  const asset::Asset& asset_;
  const Arguments& arguments_;
  QueryStage stage_;
  Pose a_, b_;
  Scratch scratch_;
  std::vector<ClosestPoint> closest_;
  std::vector<Contact> contacts_;
  std::vector<Contact> near_;
  ContactGeometry geometry_;
};

Result<void> measure_model(const Subject& subject, const Arguments& arguments) {
  std::printf("%s: ", subject.name.c_str());
  Costs(subject.character, subject.model, arguments).measure_all();
  return {};
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) {
  using namespace pelt::programs;
  Arguments arguments;
  return measure_characters(
      {"query_costs", "Measure queries of posed characters, including posing"}, argc, argv,
      {{"--frames", arguments.frames, "Frames along the first clip"},
       {"--points", arguments.points, "Points of a batch"},
       {"--runs", arguments.runs, "Runs of which the best counts"}},
      [&](const Subject& subject) { return measure_model(subject, arguments); });
}
