/// Measures bounds and culling of a posed skin, and the same with everything skinned: all vertices
/// and their box; or all vertices, all boxes of the tree bottom-up, and the same query. Each time
/// is a median over poses from all clips; the time of a pose is the best of several runs. The
/// answers are compared, and nothing is printed if they differ.

#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <pelt/asset.hpp>
#include <pelt/bounds.hpp>
#include <pelt/solid.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
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

void open_all(Pose& pose) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  make_table(posed);
  detail::open_all(posed);
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

/// Times a query in microseconds, without setting the palette.
class Stopwatch {
 public:
  explicit Stopwatch(int runs) : runs_(runs) {}

  double best(Pose& pose, const std::vector<Matrix4>& palette,
              const std::function<Answer(Pose&)>& ask) const {
    double best = 1e30;
    for (int run = 0; run < runs_; ++run) {
      (void)pose.set_palette(palette);
      const auto begin = std::chrono::steady_clock::now();
      ask(pose);
      const std::chrono::duration<double, std::micro> took =
          std::chrono::steady_clock::now() - begin;
      best = std::min(best, took.count());
    }
    return best;
  }

 private:
  int runs_;
};

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

bool measure(const std::string& path, int runs) {
  const Result<asset::Asset> asset = asset::load_gltf(path);
  if (!asset) return std::cerr << asset.error().message << '\n', false;
  const auto model = build_model(asset->mesh(), {.off_weights = OffWeights::renormalise});
  if (!model) return std::cerr << model.error().message << '\n', false;
  Pose pose(*model);
  const Stopwatch stopwatch(runs);
  Questions questions;
  for (const Question& question : questions.all()) {
    std::vector<double> lazy, eager;
    for (const std::vector<Matrix4>& palette : palettes_of(*asset)) {
      if (!pose.set_palette(palette)) continue;
      questions.place(bounds_of(pose).sphere);
      const Answer answer = question.on_demand(pose);
      if (!pose.set_palette(palette) || !agree(question, answer, question.eager(pose)))
        return std::cerr << path << ": " << question.name << ": answers differ\n", false;
      lazy.push_back(stopwatch.best(pose, palette, question.on_demand));
      eager.push_back(stopwatch.best(pose, palette, question.eager));
    }
    std::cout << path << ',' << question.name << ',' << std::setprecision(3) << median(lazy) << ','
              << median(eager) << ',' << median(eager) / median(lazy) << std::endl;
  }
  return true;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Measure bounds and culling of posed skins, on demand and with everything skinned");
  std::vector<std::string> models;
  int runs = 20;
  app.add_option("MODELS", models, "Characters with clips (.glb)")->required();
  app.add_option("--runs", runs, "Number of runs, of which the best counts")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::cout << "model,question,on_demand_us,eager_us,ratio\n";
  for (const std::string& path : models)
    if (!measure(path, runs)) return 1;
  return 0;
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) { return pelt::programs::parse_and_run(argc, argv); }
