/// Rays, bounds and farthest vertices of one body.

#include "bounds/box_of_triangles.hpp"
#include "ray/ray_oracle.hpp"
#include "support/contract/query.hpp"

#include <array>

namespace pelt::contract {
namespace {

using Hits = std::vector<RayHit>;

Facing facing_of(std::size_t ray) {
  constexpr Facing kFacings[] = {Facing::both, Facing::front, Facing::back};
  return kFacings[ray % 3];
}

Hits hits_of(const Stage& stage, std::size_t ray) {
  return test::RayOracle(stage.a.shape.triangles, stage.a.to).all(stage.rays[ray], facing_of(ray));
}

/// All rays at once, hit from both sides; then one by one, hit from the side of each.
QueryStats cast_rays(Stage& stage, Hits& found) {
  const std::size_t count = stage.rays.size();
  found.resize(2 * count);
  QueryStats work = cast(stage.a.to, stage.rays, std::span(found).first(count));
  for (std::size_t i = 0; i < count; ++i)
    work += cast(stage.a.to, stage.rays[i], found[count + i], facing_of(i));
  return work;
}

void expect_first_hits(const Stage& stage, const Hits& found) {
  const test::RayOracle oracle(stage.a.shape.triangles, stage.a.to);
  const std::size_t count = stage.rays.size();
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const Ray& ray = stage.rays[i % count];
    const Hits all = oracle.all(ray, i < count ? Facing::both : facing_of(i - count));
    EXPECT_EQ(test::without_location(found[i]), all.empty() ? RayHit() : all[0]);
  }
}

constexpr std::size_t kRays = 12;

QueryStats cast_any_rays(Stage& stage, std::array<bool, kRays>& found) {
  QueryStats work;
  for (std::size_t i = 0; i < kRays; i += 3)
    for (std::size_t j = i; j < i + 3; ++j)
      work += cast_any(stage.a.to, std::span(stage.rays).subspan(j, 1),
                       std::span(found).subspan(j, 1), facing_of(j));
  return work;
}

QueryStats cast_through(Stage& stage, Hits& found, std::uint32_t) {
  QueryStats work;
  const std::size_t before = found.size();
  for (std::size_t i = 0; i < stage.rays.size(); ++i)
    work += cast_all(stage.a.to, stage.rays[i], stage.scratch, found, facing_of(i));
  for (std::size_t i = before; i < found.size(); ++i) found[i] = test::without_location(found[i]);
  return work;
}

constexpr std::array<std::uint32_t, 4> kLevels = {0, 1, 2, 200};
using BoundsOfLevels = std::array<Bounds, kLevels.size()>;

QueryStats find_bounds(Stage& stage, BoundsOfLevels& found) {
  QueryStats work;
  for (std::size_t i = 0; i < found.size(); ++i) work += bounds(stage.a.to, found[i], kLevels[i]);
  return work;
}

void expect_encloses(const Stage& stage, const BoundsOfLevels& found) {
  const std::vector<Vec3> positions = positions_of(stage.a.to);
  const Box exact = test::box_of(stage.a.shape.triangles, positions);
  for (const Bounds& one : found) {
    EXPECT_TRUE(test::encloses(one.box, exact));
    EXPECT_TRUE(test::encloses(one.sphere, stage.a.shape.triangles, positions));
    EXPECT_TRUE(test::encloses(found[0].box, one.box));
  }
}

void expect_exact(const Stage& stage, const Bounds& found) {
  const std::vector<Vec3> positions = positions_of(stage.a.to);
  EXPECT_TRUE(test::same_bits(found.box, test::box_of(stage.a.shape.triangles, positions)));
  EXPECT_TRUE(test::encloses(found.sphere, stage.a.shape.triangles, positions));
}

/// For each group, the bound, and the exact box.
QueryStats find_group_boxes(Stage& stage, std::vector<Box>& found) {
  QueryStats work;
  found.resize(2 * std::size_t{stage.groups.count()});
  for (std::uint32_t g = 0; g < stage.groups.count(); ++g) {
    work += group_bounds(stage.a.to, stage.groups, g, found[2 * g]);
    work += exact_group_bounds(stage.a.to, stage.groups, g, found[2 * g + 1]);
  }
  return work;
}

/// Groups of joints: tests/bounds compares their vertices with the definition.
void expect_groups(const Stage& stage, const std::vector<Box>& found) {
  Box whole = test::nothing();
  for (std::size_t i = 0; i < found.size(); i += 2) {
    if (found[i + 1].low.x > found[i + 1].high.x) continue;  // a group without vertices
    EXPECT_TRUE(test::encloses(found[i], found[i + 1]));
    test::include(found[i + 1].low, whole), test::include(found[i + 1].high, whole);
  }
  EXPECT_TRUE(
      test::same_bits(whole, test::box_of(stage.a.shape.triangles, positions_of(stage.a.to))));
}

QueryStats find_farthest(Stage& stage, std::vector<FarthestVertex>& found) {
  QueryStats work;
  found.resize(stage.directions.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    work += farthest_vertex(stage.a.to, stage.directions[i], found[i]);
  return work;
}

/// In long double, which is exact for the directions of a stage and usual positions.
long double along(const Vec3& d, const Vec3& p) {
  return static_cast<long double>(d.x) * static_cast<long double>(p.x) +
         static_cast<long double>(d.y) * static_cast<long double>(p.y) +
         static_cast<long double>(d.z) * static_cast<long double>(p.z);
}

void expect_farthest(const Stage& stage, const std::vector<FarthestVertex>& found) {
  const std::vector<Vec3> positions = positions_of(stage.a.to);
  const std::vector<Triangle>& triangles = stage.a.shape.triangles;
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::pair<std::uint32_t, std::uint32_t> best;
    const auto at = [&](std::uint32_t t, std::uint32_t corner) {
      return along(stage.directions[i], positions[triangles[t][corner]]);
    };
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t corner = 0; corner < 3; ++corner)
        if (at(t, corner) > at(best.first, best.second)) best = {t, corner};
    ASSERT_TRUE(found[i]);
    EXPECT_EQ(std::pair(found[i].triangle, found[i].corner), best);
    EXPECT_EQ(found[i].position, positions[triangles[best.first][best.second]]);
  }
}

template <typename Answer>
bool always(const Answer&) {
  return true;
}

}  // namespace

void add_ray_and_bounds_queries(Queries& queries) {
  add(queries, ValueRow<Hits>{.name = "Cast",
                              .ask = cast_rays,
                              .expect_right = expect_first_hits,
                              .is_hit =
                                  [](const Hits& hits) {
                                    return std::any_of(hits.begin(), hits.end(),
                                                       [](const RayHit& hit) { return bool(hit); });
                                  },
                              .traits = {.always_hits = true}});
  add(queries, ValueRow<std::array<bool, kRays>>{
                   .name = "CastAny",
                   .ask = cast_any_rays,
                   .expect_right =
                       [](const Stage& s, const std::array<bool, kRays>& found) {
                         for (std::size_t i = 0; i < kRays; ++i)
                           EXPECT_EQ(found[i], !hits_of(s, i).empty());
                       },
                   .is_hit = [](const std::array<bool, kRays>& found) { return found[0]; }});
  add(queries, ListRow<RayHit>{.name = "CastAll",
                               .ask = cast_through,
                               .brute_force =
                                   [](const Stage& s) {
                                     Hits all;
                                     for (std::size_t i = 0; i < s.rays.size(); ++i)
                                       for (const RayHit& hit : hits_of(s, i)) all.push_back(hit);
                                     return all;
                                   },
                               .traits = {.always_hits = true}});
  add(queries,
      ValueRow<BoundsOfLevels>{.name = "Bounds",
                               .ask = find_bounds,
                               .expect_right = expect_encloses,
                               .is_hit = always<BoundsOfLevels>,
                               .traits = {.always_hits = true, .depends_on_skinning = true}});
  add(queries,
      ValueRow<Bounds>{.name = "ExactBounds",
                       .ask = [](Stage& s, Bounds& found) { return exact_bounds(s.a.to, found); },
                       .expect_right = expect_exact,
                       .is_hit = always<Bounds>,
                       .traits = {.always_hits = true, .depends_on_skinning = true}});
  add(queries,
      ValueRow<std::vector<Box>>{
          .name = "GroupBounds",
          .ask = find_group_boxes,
          .expect_right = expect_groups,
          .is_hit = always<std::vector<Box>>,
          .traits = {.varies_in_work = true, .always_hits = true, .depends_on_skinning = true}});
  add(queries, ValueRow<std::vector<FarthestVertex>>{.name = "FarthestVertex",
                                                     .ask = find_farthest,
                                                     .expect_right = expect_farthest,
                                                     .is_hit = always<std::vector<FarthestVertex>>,
                                                     .traits = {.always_hits = true}});
}

}  // namespace pelt::contract
