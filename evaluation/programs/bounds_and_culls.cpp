/// Measures bounds and culling of a posed skin, and the same with everything skinned: all vertices
/// and their box; or all vertices, all boxes of the tree bottom-up, and the same query. Each time
/// is a median over poses from all clips; the time of a pose is the best of several runs. The
/// answers are compared, and nothing is printed if they differ.

#include "evaluation/bench/csv.hpp"
#include "evaluation/programs/program.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <pelt/bounds.hpp>
#include <pelt/solid.hpp>

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace pelt::programs {
namespace {

using tools::output::median;

/// An answer as numbers, for comparison.
using Answer = std::vector<double>;

/// A query of one pose, on demand and with everything skinned.
struct Question {
  std::string name;
  std::function<Answer(Pose&)> on_demand, eager;
  bool same_answer = true;  ///< false: the eager answer is inside the other
};

Answer numbers(const Box& box) {
  return {double{box.low.x},  double{box.low.y},  double{box.low.z},
          double{box.high.x}, double{box.high.y}, double{box.high.z}};
}

Box skin_all(Pose& pose, std::vector<Vec3>& positions) {
  positions.resize(pose.model().vertex_count());
  posed_vertices(pose, positions);
  Box box = {positions[0], positions[0]};
  for (const Vec3& p : positions) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

Bounds bounds_of(Pose& pose, std::uint32_t levels = 0) {
  Bounds found;
  bounds(pose, found, levels);
  return found;
}

Box exact_box(Pose& pose) {
  Bounds found;
  exact_bounds(pose, found);
  return found.box;
}

class Questions {
 public:
  /// Places later regions around this sphere.
  void place(const Sphere& around) { around_ = around; }

  std::vector<Question> all() {
    const auto skinned = [this](Pose& pose) { return numbers(skin_all(pose, positions_)); };
    std::vector<Question> questions = {
        {"box", [](Pose& pose) { return numbers(bounds_of(pose).box); }, skinned, false},
        {"box_3_levels", [](Pose& pose) { return numbers(bounds_of(pose, 3).box); }, skinned,
         false},
        {"box_exact", [](Pose& pose) { return numbers(exact_box(pose)); }, skinned}};
    for (const auto& [name, place] : {std::pair("apart", 3.0f), std::pair("across", 0.4f)}) {
      questions.push_back(placed("half_space_" + std::string(name), place, half_space));
      questions.push_back(placed("sphere_" + std::string(name), place, sphere));
    }
    questions.push_back(found("triangles_in_sphere", 0.4f, sphere));
    return questions;
  }

 private:
  using MakeRegion = Region (*)(const Sphere& around, float place);

  static Region half_space(const Sphere& around, float place) {
    return HalfSpace{{-1, 0, 0}, -around.centre.x - place * around.radius};
  }

  static Region sphere(const Sphere& around, float place) {
    const Vec3& c = around.centre;
    return Sphere{{c.x, c.y + place * around.radius, c.z}, around.radius * 0.2f};
  }

  template <typename Ask>
  Question asked(std::string name, const Ask& ask) {
    return {std::move(name), ask, [ask](Pose& pose) {
              open_all(pose);
              return ask(pose);
            }};
  }

  Question placed(std::string name, float place, MakeRegion make) {
    return asked(std::move(name), [this, place, make](Pose& pose) -> Answer {
      const Region where = make(around_, place);
      Placement placement = Placement::outside;
      classify(pose, where, scratch_, placement);
      return {static_cast<double>(placement)};
    });
  }

  Question found(std::string name, float place, MakeRegion make) {
    return asked(std::move(name), [this, place, make](Pose& pose) -> Answer {
      const Region where = make(around_, place);
      triangles_.intersecting.clear();
      triangles_.inside.clear();
      find_triangles(pose, where, scratch_, triangles_);
      return Answer(triangles_.intersecting.begin(), triangles_.intersecting.end());
    });
  }

  Sphere around_;
  Scratch scratch_;
  TrianglesInRegion triangles_;
  std::vector<Vec3> positions_;
};

/// The best time of a query in microseconds, without setting the palette.
double best_time(Pose& pose, const std::vector<Matrix4>& palette,
                 const std::function<Answer(Pose&)>& ask, std::uint32_t runs) {
  double best = HUGE_VAL;
  for (std::uint32_t run = 0; run < runs; ++run) {
    (void)pose.set_palette(palette);
    best = std::min(best, microseconds([&] { ask(pose); }));
  }
  return best;
}

std::vector<std::vector<Matrix4>> palettes_of(const asset::Asset& asset) {
  constexpr int kOfEachClip = 3;
  asset::SampleScratch scratch;
  std::vector<std::vector<Matrix4>> palettes;
  for (const asset::Clip& clip : asset.clips)
    for (int i = 0; i < kOfEachClip; ++i) {
      palettes.emplace_back(asset.joints.size());
      sample_palette(asset, &clip, clip.duration * static_cast<float>(i) / kOfEachClip, {}, scratch,
                     palettes.back());
    }
  return palettes;
}

bool agree(const Question& question, const Answer& lazy, const Answer& eager) {
  if (question.same_answer) return lazy == eager;
  for (std::size_t i = 0; i < 3; ++i)
    if (lazy[i] > eager[i] || lazy[i + 3] < eager[i + 3]) return false;
  return true;
}

Result<void> measure_model(const Subject& subject, std::uint32_t runs, lab::CsvWriter& table) {
  Pose pose(subject.model);
  Questions questions;
  for (const Question& question : questions.all()) {
    std::vector<double> lazy, eager;
    for (const std::vector<Matrix4>& palette : palettes_of(subject.character.asset)) {
      if (!pose.set_palette(palette)) continue;
      questions.place(bounds_of(pose).sphere);
      const Answer answer = question.on_demand(pose);
      if (!pose.set_palette(palette) || !agree(question, answer, question.eager(pose)))
        return Error{ErrorCode::invalid_argument,
                     subject.name + ": " + question.name + ": answers differ"};
      lazy.push_back(best_time(pose, palette, question.on_demand, runs));
      eager.push_back(best_time(pose, palette, question.eager, runs));
    }
    table.write({{"model", subject.name},
                 {"question", question.name},
                 {"on_demand_us", median(lazy)},
                 {"eager_us", median(eager)},
                 {"ratio", median(eager) / median(lazy)}});
    std::cout.flush();
  }
  return {};
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) {
  using namespace pelt::programs;
  std::uint32_t runs = 20;
  std::cout << std::setprecision(3);
  pelt::lab::CsvWriter table(std::cout);
  return measure_characters(
      {"bounds_and_culls",
       "Measure bounds and culling of posed skins, on demand and with everything skinned"},
      argc, argv, {{"--runs", runs, "Number of runs, of which the best counts"}},
      [&](const Subject& subject) { return measure_model(subject, runs, table); });
}
