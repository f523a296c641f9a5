/// Walking crowds, queried as a whole by one thread, and pair by pair.

#include "evaluation/programs/crowd.hpp"
#include "evaluation/reproduce/growth.hpp"
#include "evaluation/reproduce/pairwise_run.hpp"
#include "text/format.hpp"

namespace pelt::reproduce {
namespace {

/// Units of the creature per metre of the crowd; dense enough that small crowds have contacts too.
constexpr double kMetre = 1.2;

/// A creature, and crowds of it.
struct Walkers {
  explicit Walkers(const asset::Asset& asset, const SkinnedModel& m) : model(m), phases(asset) {}

  SkinnedModel model;
  programs::WalkPhases phases;
};

Result<Walkers> make_walkers() {
  const Result<asset::Asset> asset = scenes::make_creature();
  if (!asset) return asset.error();
  const std::vector<Matrix4> samples = programs::WalkPhases(*asset).samples();
  const Result<SkinnedModel> model = build_model(asset->mesh(), {.sample_palettes = samples});
  if (!model) return model.error();
  return Walkers(*asset, *model);
}

/// Adds the times of all methods that are queried pair by pair to those of the crowd.
Result<void> append_pairwise(const programs::CrowdJob& job, const programs::CrowdTiming& crowd,
                             std::vector<Cell>& row) {
  for (const methods::MethodKind method : kPairMethods) {
    const PairwiseTiming timing = PairwiseRun(job, method).run();
    if (timing.contacts != crowd.contacts)
      return Error{ErrorCode::invalid_argument,
                   std::string(method.name) + " finds " + std::to_string(timing.contacts) +
                       " contacts between " + std::to_string(job.models.size()) +
                       " walkers, but the crowd query finds " + std::to_string(crowd.contacts) +
                       ": please report this"};
    row.push_back(timing.frame_us);
  }
  return {};
}

Result<std::vector<Cell>> crowd_row(const Walkers& walkers, std::uint32_t count, bool by_pairs,
                                    const Conditions& conditions) {
  const programs::WalkingCrowd crowd(walkers.phases, count, kMetre);
  programs::CrowdJob job;
  job.models.assign(count, walkers.model);
  job.frame_count = conditions.is_quick ? 3 : 9;
  job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
    crowd.pose(frame, palettes);
  };
  const programs::CrowdTiming timing =
      programs::CrowdRun(job).best_of(conditions.is_quick ? 1 : 3, 1);
  std::vector<Cell> row = {static_cast<double>(count), static_cast<double>(timing.contacts),
                           static_cast<double>(timing.stats.intersecting_pairs)};
  if (by_pairs) {
    if (const auto done = append_pairwise(job, timing, row); !done) return done.error();
  } else {
    row.resize(row.size() + kPairMethods.size());
  }
  row.push_back(1000 * timing.frame_ms);
  return row;
}

}  // namespace

Result<Table> growth_by_instances(std::span<const std::uint32_t> instances,
                                  std::uint32_t most_by_pairs, const Conditions& conditions) {
  const Result<Walkers> walkers = make_walkers();
  if (!walkers) return walkers.error();
  Table table = {
      "growth_instances",
      "Time per frame, by number of instances",
      {{"instances", "instances"},
       {"contacts", "contacts"},
       {"touching_pairs", "pairs in contact"}},
      {},
      "Creatures of " + text::with_commas(walkers->model.triangle_count()) +
          " triangles that walk on a plain, 0.5 to 1.4 units from their neighbours. The time is "
          "that of setting palettes and finding all contacts on one thread. Contacts are those of "
          "the last timed frame."};
  for (const GrowingMethod& method : kGrowingMethods) table.columns.push_back(method.column());
  for (const std::uint32_t count : instances) {
    auto row = crowd_row(*walkers, count, count <= most_by_pairs, conditions);
    if (!row) return row.error();
    table.rows.push_back(std::move(*row));
  }
  return table;
}

}  // namespace pelt::reproduce
