/// Measures a pick, and a thousand rays at a posed character, including posing: on demand, with the
/// same tree skinned and opened completely, and by Embree on skinned vertices if it is built in.
///
/// Each pose of a clip is set, prepared as the method requires, and queried. Times are medians over
/// the poses; each pose's time is the best of several runs. Rays come from all around: most are
/// aimed at triangles, the others graze the body or miss it. Prints nothing if the two trees give
/// different answers. Counts the differences of Embree, which is not exact.

#include "evaluation/programs/program.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <pelt/ray.hpp>

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
  std::uint32_t rays = 1000, poses = 12, runs = 5;
};

struct Extent {
  Vec3 centre;
  double radius = 0;
};

Extent extent_of(std::span<const Vec3> positions) {
  Vec3 low = positions[0], high = positions[0];
  for (const Vec3& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double x = double{high.x} - double{low.x}, y = double{high.y} - double{low.y};
  const double z = double{high.z} - double{low.z};
  return {{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2},
          std::sqrt(x * x + y * y + z * z) / 2};
}

Vec3 around(const Extent& extent, Numbers& numbers, double distance) {
  const double turn = numbers.between(0, 6.283), height = numbers.between(-0.7, 0.7);
  const double r = distance * extent.radius, flat = r * std::sqrt(1 - height * height);
  return {static_cast<float>(double{extent.centre.x} + flat * std::cos(turn)),
          static_cast<float>(double{extent.centre.y} + height * r),
          static_cast<float>(double{extent.centre.z} + flat * std::sin(turn))};
}

/// Makes rays in groups of ten: six aim at the middle of a triangle, two at a vertex, which is
/// often on the outline, and two at points around the body.
std::vector<Ray> make_rays(const asset::Asset& asset, std::span<const Vec3> positions,
                           std::uint32_t count) {
  const Extent extent = extent_of(positions);
  Numbers numbers(7);
  std::vector<Ray> rays;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [a, b, c] = asset.triangles[numbers.below(asset.triangles.size())];
    const Vec3 &p = positions[a], &q = positions[b], &r = positions[c];
    const Vec3 middle = {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
    const Vec3 target = i % 10 < 6 ? middle : i % 10 < 8 ? p : around(extent, numbers, 0.8);
    Ray ray = segment(around(extent, numbers, 3), target);
    ray.t_max = std::numeric_limits<float>::infinity();
    rays.push_back(ray);
  }
  return rays;
}

/// A character, its palettes along the first clip, and rays for each palette.
struct Job {
  Job(const asset::Asset& a, SkinnedModel m, const Arguments& arguments)
      : asset(a), model(std::move(m)) {
    Pose pose(model);
    std::vector<Vec3> positions(model.vertex_count());
    asset::SampleScratch scratch;
    for (std::uint32_t i = 0; i < arguments.poses; ++i) {
      std::vector<Matrix4> palette(model.joint_count());
      const asset::Clip* clip = asset.clips.empty() ? nullptr : &asset.clips[0];
      const float share = static_cast<float>(i) / static_cast<float>(arguments.poses);
      asset::sample_palette(asset, clip, clip ? share * clip->duration : 0, Matrix4(), scratch,
                            palette);
      if (!pose.set_palette(palette)) continue;
      posed_vertices(pose, positions);
      rays.push_back(make_rays(asset, positions, arguments.rays));
      palettes.push_back(std::move(palette));
    }
  }

  const asset::Asset& asset;
  SkinnedModel model;
  std::vector<std::vector<Matrix4>> palettes;
  std::vector<std::vector<Ray>> rays;
};

/// A way to prepare a pose and to cast rays at it.
struct Way {
  std::string name;
  std::function<void(std::span<const Matrix4>)> pose;
  std::function<void(std::span<const Ray>, std::span<RayHit>)> cast;
};

struct Times {
  double pick_us = 0, batch_us = 0;
};

/// The time for the pose and all its rays; the best of several runs.
double best_time(const Way& way, std::span<const Matrix4> palette, std::span<const Ray> rays,
                 std::span<RayHit> hits, std::uint32_t runs) {
  double best = HUGE_VAL;
  for (std::uint32_t run = 0; run < runs; ++run)
    best = std::min(best, microseconds([&] {
                      way.pose(palette);
                      way.cast(rays, hits);
                    }));
  return best;
}

/// Medians over the poses. Fills `hits` with the hits of all poses, one pose after the other.
Times measure(const Job& job, const Way& way, std::uint32_t runs, std::vector<RayHit>& hits) {
  constexpr std::size_t kPicks = 20;
  std::vector<double> picks, batches;
  hits.clear();
  for (std::size_t i = 0; i < job.palettes.size(); ++i) {
    std::vector<RayHit> found(job.rays[i].size());
    batches.push_back(best_time(way, job.palettes[i], job.rays[i], found, runs));
    for (std::size_t k = 0; k < std::min(kPicks, found.size()); ++k)
      picks.push_back(best_time(way, job.palettes[i], std::span(job.rays[i]).subspan(k, 1),
                                std::span(found).subspan(k, 1), runs));
    hits.insert(hits.end(), found.begin(), found.end());
  }
  return {median(picks), median(batches)};
}

void print(const Way& way, const Times& times, const Times& ours) {
  std::printf("  %-22s pick %9.2f us %7.1fx   batch %9.1f us %6.2fx\n", way.name.c_str(),
              times.pick_us, times.pick_us / ours.pick_us, times.batch_us,
              times.batch_us / ours.batch_us);
}

Way on_demand(Pose& pose) {
  return {"on demand", [&](std::span<const Matrix4> palette) { (void)pose.set_palette(palette); },
          [&](std::span<const Ray> rays, std::span<RayHit> hits) { cast(pose, rays, hits); }};
}

Way eager(Pose& pose) {
  return {"same tree, all opened",
          [&](std::span<const Matrix4> palette) {
            (void)pose.set_palette(palette);
            open_all(pose);
          },
          [&](std::span<const Ray> rays, std::span<RayHit> hits) { cast(pose, rays, hits); }};
}

#ifdef PELT_BENCH_PEERS

void print_differences(std::span<const RayHit> ours, std::span<const RayHit> theirs) {
  std::size_t lost = 0, made_up = 0, elsewhere = 0, ties = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i].triangle == theirs[i].triangle) continue;
    lost += !theirs[i];
    made_up += !ours[i];
    if (!ours[i] || !theirs[i]) continue;
    ++(std::abs(ours[i].t - theirs[i].t) <= 1e-5f * ours[i].t ? ties : elsewhere);
  }
  std::printf(
      "  Embree differs: %zu hits missing, %zu extra, %zu elsewhere, %zu on edges, of %zu\n", lost,
      made_up, elsewhere, ties, ours.size());
}

void measure_embree(const Job& job, const Arguments& arguments, const Times& ours,
                    std::span<const RayHit> hits) {
  using peers::RayCalls;
  Pose pose(job.model);
  peers::EmbreeMesh embree(job.asset.triangles, job.model.vertex_count());
  std::vector<RayHit> theirs;
  for (const auto& [name, calls] : {std::pair("Embree, one by one", RayCalls::one),
                                    std::pair("Embree, eights", RayCalls::eight),
                                    std::pair("Embree, stream", RayCalls::stream)}) {
    const RayCalls form = calls;
    const Way way = {name,
                     [&](std::span<const Matrix4> palette) {
                       (void)pose.set_palette(palette);
                       posed_vertices(pose, embree.positions());
                       embree.refit();
                     },
                     [&](std::span<const Ray> rays, std::span<RayHit> found) {
                       embree.cast(rays, found, form);
                     }};
    print(way, measure(job, way, arguments.runs, theirs), ours);
  }
  print_differences(hits, theirs);
}

#else

void measure_embree(const Job&, const Arguments&, const Times&, std::span<const RayHit>) {}

#endif

Result<void> measure_model(const Subject& subject, const Arguments& arguments) {
  const Job job(subject.character.asset, subject.model, arguments);

  Pose pose(subject.model), opened(subject.model);
  const Way ours = on_demand(pose), whole = eager(opened);
  std::vector<RayHit> hits, whole_hits;
  const Times times = measure(job, ours, arguments.runs, hits);
  const Times whole_times = measure(job, whole, arguments.runs, whole_hits);
  if (hits != whole_hits)
    return Error{ErrorCode::invalid_argument, subject.name + ": the two trees' answers differ"};
  const auto hit = std::count_if(hits.begin(), hits.end(), [](const RayHit& h) { return bool(h); });
  std::printf("%s: %u triangles, %.0f of 100 rays hit\n", subject.name.c_str(),
              subject.model.triangle_count(),
              100 * static_cast<double>(hit) / static_cast<double>(hits.size()));
  print(ours, times, times);
  print(whole, whole_times, times);
  measure_embree(job, arguments, times, hits);
  return {};
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) {
  using namespace pelt::programs;
  Arguments arguments;
  return measure_characters(
      {"ray_casting", "Measure rays at a posed character, including posing"}, argc, argv,
      {{"--rays", arguments.rays, "Number of rays of a batch"},
       {"--poses", arguments.poses, "Poses along the first clip"},
       {"--runs", arguments.runs, "Runs of which the best counts"}},
      [&](const Subject& subject) { return measure_model(subject, arguments); });
}
