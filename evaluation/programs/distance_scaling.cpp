/// Measures the distance of two walkers, from near to far: on demand, on demand with the answer of
/// the last frame as a hint, and with everything skinned and boxed. All answer the same frames in
/// turn, so each finds the caches as the others leave them. Prints medians, because other programs
/// may use the machine. Prints nothing if answers differ.

#include "collide/eager.hpp"
#include "distance/distance_search.hpp"
#include "evaluation/bench/csv.hpp"
#include "evaluation/programs/crowd.hpp"
#include "evaluation/programs/program.hpp"
#include "model/model.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <pelt/distance.hpp>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>

namespace pelt::programs {
namespace {

namespace bench = tools::bench;

using tools::output::median;

struct Arguments {
  std::string input;
  double metre = 1;
  std::uint32_t rounds = 3;
};

/// Distances between the walkers' roots in metres.
constexpr double kShifts[] = {0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0};

/// About half a step between the walkers.
constexpr std::uint32_t kPhaseShift = 23;

using Palette = std::vector<Matrix4>;

Palette moved(std::span<const Matrix4> palette, double x) {
  Palette result(palette.begin(), palette.end());
  for (Matrix4& m : result) m.m[12] += static_cast<float>(x);
  return result;
}

/// One value per frame for each column.
struct Samples {
  std::vector<double> distance, palettes, demand, hinted, eager_open, eager_query;
  std::vector<double> refits, hinted_refits, node_pairs, exact_node_pairs, triangle_pairs;
};

struct Walkers {
  explicit Walkers(const SkinnedModel& m)
      : model(m), a(m), b(m), exact_a(m.detail().tree), exact_b(m.detail().tree) {}

  /// Precondition: the palettes belong to this model.
  void pose(const Palette& palette_a, const Palette& palette_b) {
    (void)a.set_palette(palette_a);
    (void)b.set_palette(palette_b);
  }

  /// The closest triangles of the exact poses. Preconditions: all nodes are open in both, and the
  /// surfaces do not touch.
  QueryStats closest_eagerly(detail::TriangleGap& closest) {
    const detail::SearchLimits no_limits = {std::numeric_limits<double>::infinity(), 0, nullptr};
    return detail::closest_triangles(exact_a.posed_tree(), exact_b.posed_tree(), scratch.detail(),
                                     no_limits, closest);
  }

  SkinnedModel model;
  Pose a, b;
  detail::EagerPose exact_a, exact_b;
  Scratch scratch;
};

double as_sample(std::uint64_t count) { return static_cast<double>(count); }

/// Queries one frame in all ways. Returns false if the answers differ. `last` is the answer of the
/// previous frame.
bool ask(Walkers& walkers, const Palette& palette_a, const Palette& palette_b, Distance& last,
         Samples& samples) {
  Distance plain, hinted;
  QueryStats stats;
  samples.palettes.push_back(microseconds([&] { walkers.pose(palette_a, palette_b); }));
  samples.demand.push_back(
      microseconds([&] { stats = distance(walkers.a, walkers.b, walkers.scratch, plain); }));
  samples.refits.push_back(as_sample(stats.refits));
  samples.node_pairs.push_back(as_sample(stats.node_pairs));
  samples.triangle_pairs.push_back(as_sample(stats.triangle_pairs));

  (void)walkers.exact_a.set_palette(palette_a);
  (void)walkers.exact_b.set_palette(palette_b);
  detail::TriangleGap exact;
  samples.eager_open.push_back(microseconds([&] {
    walkers.exact_a.open_all();
    walkers.exact_b.open_all();
  }));
  samples.eager_query.push_back(microseconds([&] { stats = walkers.closest_eagerly(exact); }));
  samples.exact_node_pairs.push_back(as_sample(stats.node_pairs));

  walkers.pose(palette_a, palette_b);
  samples.hinted.push_back(microseconds(
      [&] { stats = distance(walkers.a, walkers.b, walkers.scratch, hinted, {.hint = &last}); }));
  samples.hinted_refits.push_back(as_sample(stats.refits));
  samples.distance.push_back(plain.distance);
  last = plain;
  return hinted.distance == plain.distance &&
         (plain.distance == 0 || std::sqrt(exact.closest.squared_distance) == plain.distance);
}

bench::Row row_of(double shift, double metre, const Samples& s) {
  const double demand = median(s.demand), hinted = median(s.hinted);
  const double eager = median(s.eager_open) + median(s.eager_query);
  return {{"shift_m", shift},
          {"distance_m", median(s.distance) / metre},
          {"palettes_us", median(s.palettes)},
          {"demand_us", demand},
          {"hinted_us", hinted},
          {"eager_open_us", median(s.eager_open)},
          {"eager_query_us", median(s.eager_query)},
          {"eager_per_demand", eager / demand},
          {"eager_per_hinted", eager / hinted},
          {"refits", median(s.refits)},
          {"hinted_refits", median(s.hinted_refits)},
          {"node_pairs", median(s.node_pairs)},
          {"exact_node_pairs", median(s.exact_node_pairs)},
          {"triangle_pairs", median(s.triangle_pairs)}};
}

bool measure(Walkers& walkers, const WalkPhases& phases, const Arguments& arguments) {
  std::cout << std::setprecision(4);
  lab::CsvWriter table(std::cout);
  for (const double shift : kShifts) {
    Samples samples;
    Distance last;
    for (std::uint32_t frame = 0; frame < arguments.rounds * WalkPhases::kCount; ++frame) {
      const auto phase = [&](std::uint32_t ahead) {
        return phases[(frame + ahead) % WalkPhases::kCount];
      };
      if (!ask(walkers, moved(phase(0), 0), moved(phase(kPhaseShift), shift * arguments.metre),
               last, samples))
        return false;
    }
    table.write(row_of(shift, arguments.metre, samples));
  }
  return true;
}

constexpr Program kProgram = {"distance_scaling",
                              "Measure the distance of two walkers, on demand and eagerly"};

int run(const Arguments& arguments) {
  const Result<scenes::Character> character = scenes::load_character(arguments.input);
  if (!character) return fail(kProgram, character.error().message);
  const WalkPhases phases(character->asset);
  const std::vector<Matrix4> samples = phases.samples();
  const Result<SkinnedModel> model =
      build_model(character->asset.mesh(),
                  {.off_weights = OffWeights::renormalise, .sample_palettes = samples});
  if (!model) return fail(kProgram, model.error().message);
  Walkers walkers(*model);
  if (!measure(walkers, phases, arguments)) return fail(kProgram, "the answers differ");
  return 0;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(kProgram.description);
  Arguments arguments;
  app.add_option("INPUT", arguments.input, "A character (.glb) that walks")->required();
  app.add_option("--metre", arguments.metre, "Length of a metre in units of the character");
  app.add_option("--rounds", arguments.rounds, "Number of passes over the clip");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) { return pelt::programs::parse_and_run(argc, argv); }
