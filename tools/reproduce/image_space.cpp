#include "tools/reproduce/image_space.hpp"

#include "bench/method.hpp"
#include "bench/statistics.hpp"
#include "rivals/layered_depth.hpp"
#include "tools/pelt/scene_query.hpp"
#include "tools/pelt/stopwatch.hpp"
#include "tools/reproduce/facing_pair.hpp"

#include <algorithm>
#include <array>

namespace pelt::reproduce {
namespace {

/// The palettes of two characters at one distance, their vertices, and whether they touch.
struct Case {
  tools::Palettes palettes;
  std::array<std::vector<Vec3>, 2> positions;
  bool is_touching = false;
};

/// From hands that just do not meet to two in one place; light contacts, which are hard to see,
/// lie closest together.
std::vector<double> distances(const Conditions& conditions) {
  const int count = conditions.is_quick ? 16 : 64;
  std::vector<double> all;
  for (int i = 0; i < count; ++i) {
    const double x = 1 - static_cast<double>(i) / (count - 1);
    all.push_back(0.9 * (1 - (1 - x) * (1 - x)));
  }
  return all;
}

class Oracle {
 public:
  explicit Oracle(const SkinnedModel& model)
      : poses_{Pose(model), Pose(model)}, positions_(model.vertex_count()) {}

  Result<Case> ask(const scenes::Scene& scene) {
    Case asked;
    tools::sample_palettes(scene, 0, scratch_, asked.palettes);
    for (std::size_t i = 0; i < 2; ++i) {
      if (const auto set = poses_[i].set_palette(std::span<const Matrix4>(asked.palettes[i])); !set)
        return set.error();
      asked.positions[i].resize(positions_.size());
      posed_vertices(poses_[i], asked.positions[i]);
    }
    asked.is_touching = intersects(poses_[0], poses_[1], query_);
    return asked;
  }

 private:
  std::array<Pose, 2> poses_;
  std::vector<Vec3> positions_;
  asset::SampleScratch scratch_;
  Scratch query_;
};

struct Tally {
  double missed = 0, invented = 0;
  std::vector<double> times;
};

/// Drawing and comparing alone: skinning is told beside it.
Tally tally_of(std::span<const Case> cases, std::span<const Triangle> triangles,
               std::uint32_t resolution) {
  rivals::LayeredDepth images(resolution);
  images.add(triangles);
  images.add(triangles);
  Tally tally;
  for (const Case& asked : cases) {
    tools::Stopwatch watch;
    for (std::uint32_t i = 0; i < 2; ++i) images.update(i, asked.positions[i]);
    const bool is_touching = images.touch(0, 1);
    watch.stop();
    tally.times.push_back(watch.microseconds());
    tally.missed += asked.is_touching && !is_touching;
    tally.invented += !asked.is_touching && is_touching;
  }
  return tally;
}

/// What the exact answer takes, palettes to yes or no.
double exact_us(const SkinnedModel& model, std::span<const Case> cases) {
  std::array<Pose, 2> poses = {Pose(model), Pose(model)};
  Scratch scratch;
  std::vector<double> times;
  for (const Case& asked : cases) {
    tools::Stopwatch watch;
    for (std::size_t i = 0; i < 2; ++i)
      (void)poses[i].set_palette(std::span<const Matrix4>(asked.palettes[i]));
    (void)intersects(poses[0], poses[1], scratch);
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return bench::mean(times);
}

double skinning_us(const SkinnedModel& model, const Case& asked) {
  Pose pose(model);
  (void)pose.set_palette(std::span<const Matrix4>(asked.palettes[0]));
  std::vector<Vec3> positions(model.vertex_count());
  std::vector<double> times;
  for (int repetition = 0; repetition < 9; ++repetition) {
    tools::Stopwatch watch;
    posed_vertices(pose, positions);
    watch.stop();
    times.push_back(2 * watch.microseconds());
  }
  return bench::median(times);
}

}  // namespace

Result<Table> image_space_table(const scenes::Character& character, const Conditions& conditions) {
  const asset::Asset& asset = character.asset;
  const Result<SkinnedModel> model = build_model(asset.mesh());
  if (!model) return model.error();
  Oracle oracle(*model);
  std::vector<Case> cases;
  for (const double distance : distances(conditions)) {
    auto asked = oracle.ask(facing_pair(character, distance));
    if (!asked) return asked.error();
    cases.push_back(std::move(*asked));
  }
  const auto touching = static_cast<double>(
      std::count_if(cases.begin(), cases.end(), [](const Case& c) { return c.is_touching; }));
  const double skinning = skinning_us(*model, cases[0]);
  Table table = {"image_space",
                 "Layered depth images: do two creatures touch?",
                 {{"resolution", "pixels a side"},
                  {"skinning_us", "skinning [us]"},
                  {"images_us", "images [us]"},
                  {"exact_us", "Pelt, exact [us]"},
                  {"asked", "asked"},
                  {"touching", "touching"},
                  {"missed", "missed"},
                  {"missed_percent", "missed [% of touching]"},
                  {"invented", "seen where there is none"}},
                 {},
                 "Means over all distances, from apart to one place; light contacts lie closest "
                 "together. Pelt's time has its skinning."};
  const double exact = exact_us(*model, cases);
  for (const std::uint32_t resolution : {16u, 32u, 64u, 128u, 256u}) {
    const Tally tally = tally_of(cases, asset.triangles, resolution);
    table.rows.push_back({static_cast<double>(resolution), skinning, bench::mean(tally.times),
                          exact, static_cast<double>(cases.size()), touching, tally.missed,
                          100 * tally.missed / std::max(touching, 1.0), tally.invented});
  }
  return table;
}

}  // namespace pelt::reproduce
