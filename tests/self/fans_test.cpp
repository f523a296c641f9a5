#include "self/fans.hpp"

#include "model/model.hpp"
#include "model/weld.hpp"
#include "self_brute_force.hpp"
#include "surface_shapes.hpp"
#include "tests/model/meshes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace pelt::test {
namespace {

using detail::FanKind;
using detail::Fans;
using detail::kMaxFan;

/// A shape with its fans, and what brute force says about them.
struct Fanned {
  explicit Fanned(const Shape& s, bool weld = true)
      : shape(s),
        model(*build_model(shape.view(), {.weld = weld})),
        fans(model.detail().tree),
        surface(surface_vertices(shape)),
        is_cracked(cracked_vertices(weld)) {}

  const Triangle& triangle_at(std::uint32_t place) const {
    return shape.triangles[model.detail().tree.triangle_ids[place]];
  }

  /// Surface vertices whose vertices have different influences, or are not welded.
  std::set<std::uint32_t> cracked_vertices(bool weld) const {
    std::vector<std::uint32_t> welded = detail::weld_vertices(mesh_of(shape));
    if (!weld) std::iota(welded.begin(), welded.end(), 0u);
    std::map<std::uint32_t, std::uint32_t> first;
    std::set<std::uint32_t> cracked;
    std::vector<bool> is_used(welded.size(), false);
    for (const Triangle& t : shape.triangles)
      for (const std::uint32_t v : t) is_used[v] = true;
    for (std::uint32_t v = 0; v < welded.size(); ++v)
      if (is_used[v] && first.emplace(surface[v], welded[v]).first->second != welded[v])
        cracked.insert(surface[v]);
    return cracked;
  }

  Shape shape;
  SkinnedModel model;
  Fans fans;
  std::vector<std::uint32_t> surface;  // by brute force
  std::set<std::uint32_t> is_cracked;
};

/// The triangle's corners in the shape's surface vertices, starting after the fan's vertex.
struct Link {
  std::uint32_t after, before;
};

Link link_of(const Fanned& fanned, const detail::FanTriangle& t) {
  const Triangle& corners = fanned.triangle_at(t.place());
  return {fanned.surface[corners[(t.corner() + 1) % 3]],
          fanned.surface[corners[(t.corner() + 2) % 3]]};
}

/// Whether triangles around `vertex` can be ordered in a chain or cycle without repetition:
/// follows the links from triangle to triangle.
FanKind kind_by_links(const Fanned& fanned, std::span<const detail::FanTriangle> fan,
                      std::uint32_t vertex) {
  std::map<std::uint32_t, std::uint32_t> next;
  std::set<std::uint32_t> ends;
  for (const detail::FanTriangle& t : fan) {
    for (const std::uint32_t corner : fanned.triangle_at(t.place()))
      if (fanned.is_cracked.count(fanned.surface[corner])) return FanKind::cracked;
  }
  if (fan.size() > kMaxFan) return FanKind::complex;
  for (const detail::FanTriangle& t : fan) {
    const Link link = link_of(fanned, t);
    if (link.after == vertex || link.before == vertex) return FanKind::complex;
    if (!next.emplace(link.after, link.before).second) return FanKind::complex;
    if (!ends.insert(link.before).second) return FanKind::complex;
  }
  std::uint32_t start = next.begin()->first;
  for (const auto& [after, before] : next)
    if (!ends.count(after)) start = after;
  std::size_t steps = 0;
  std::uint32_t at = start;
  do {
    at = next[at];
    ++steps;
  } while (next.count(at) && at != start);
  if (steps != fan.size()) return FanKind::complex;
  return at == start ? FanKind::closed : FanKind::open;
}

void expect_ordered(const Fanned& fanned, std::span<const detail::FanTriangle> fan, FanKind kind) {
  for (std::size_t i = 0; i + 1 < fan.size(); ++i)
    ASSERT_EQ(link_of(fanned, fan[i]).before, link_of(fanned, fan[i + 1]).after);
  if (kind == FanKind::closed) {
    ASSERT_EQ(link_of(fanned, fan.back()).before, link_of(fanned, fan[0]).after);
  }
}

/// Each surface vertex has one fan, with each of its triangles once.
void expect_partition(const Fanned& fanned) {
  std::map<std::uint32_t, std::set<std::uint32_t>> expected, found;
  for (std::uint32_t t = 0; t < fanned.shape.triangles.size(); ++t)
    for (const std::uint32_t v : fanned.shape.triangles[t]) expected[fanned.surface[v]].insert(t);
  const auto& ids = fanned.model.detail().tree.triangle_ids;
  for (std::uint32_t f = 0; f < fanned.fans.count(); ++f) {
    std::set<std::uint32_t> vertices, triangles;
    for (const detail::FanTriangle& t : fanned.fans[f]) {
      vertices.insert(fanned.surface[fanned.triangle_at(t.place())[t.corner()]]);
      ASSERT_TRUE(triangles.insert(ids[t.place()]).second) << "listed twice";
    }
    ASSERT_EQ(vertices.size(), 1u);
    ASSERT_TRUE(found.emplace(*vertices.begin(), triangles).second) << "two fans of one vertex";
  }
  ASSERT_EQ(found, expected);
}

/// The runs are sorted, and each ends where the next begins.
void expect_runs(const detail::Fans& fans) {
  std::uint32_t fan = 0, triangle = 0;
  for (std::size_t r = 0; r < fans.runs.size(); ++r) {
    const detail::FanRun& run = fans.runs[r];
    EXPECT_EQ(run.first_fan, fan);
    EXPECT_LT(run.first_fan, run.end);
    EXPECT_EQ(run.first_triangle, triangle);
    EXPECT_TRUE(r == 0 || std::pair(fans.runs[r - 1].kind, fans.runs[r - 1].size) <
                              std::pair(run.kind, run.size));
    fan = run.end;
    triangle += (run.end - run.first_fan) * run.size;
  }
  EXPECT_EQ(fans.count(), fan);
  EXPECT_EQ(fans.triangles.size(), triangle);
}

constexpr std::size_t kFanKinds = 4;

/// Checks all fans. Returns the number of each kind.
std::array<std::size_t, kFanKinds> expect_fans(const Shape& shape, bool weld = true) {
  const Fanned fanned(shape, weld);
  expect_partition(fanned);
  expect_runs(fanned.fans);
  std::array<std::size_t, kFanKinds> counts{};
  std::uint32_t flat = 0;
  for (std::uint32_t f = 0; f < fanned.fans.count(); ++f) {
    const FanKind kind = fanned.fans.run_of(f).kind;
    const auto fan = fanned.fans[f];
    const std::uint32_t vertex =
        fanned.surface[fanned.triangle_at(fan[0].place())[fan[0].corner()]];
    EXPECT_EQ(kind_by_links(fanned, fan, vertex), kind) << "fan " << f;
    if (detail::can_be_flat(kind)) {
      expect_ordered(fanned, fan, kind);
      flat = f + 1;
    }
    ++counts[static_cast<std::size_t>(kind)];
  }
  EXPECT_EQ(fanned.fans.flat_count(), flat);
  return counts;
}

constexpr std::size_t kClosed = 0, kOpen = 1, kComplex = 2, kCracked = 3;

TEST(Fans, OfClosedAndOpenSurfaces) {
  const auto limb = expect_fans(make_limb(20, 9, 4));
  EXPECT_GE(limb[kClosed], 20u * 9);
  EXPECT_EQ(limb[kComplex] + limb[kCracked], 0u);
  Random random(1720);
  Shape fans;
  fans.influences_per_vertex = 1;
  for (std::uint32_t size = 3; size <= kMaxFan; ++size)
    for (const bool is_closed : {false, true})
      add_fan(random, fans, size, is_closed,
              {static_cast<float>(3 * size), is_closed ? 0.f : 9, 0});
  const auto counts = expect_fans(fans);
  EXPECT_EQ(counts[kClosed], kMaxFan - 2u);
  EXPECT_EQ(counts[kComplex] + counts[kCracked], 0u);
}

TEST(Fans, WithMoreTrianglesThanTheCertificateSupports) {
  Random random(1721);
  for (const std::uint32_t size : {kMaxFan, kMaxFan + 1, 500u})
    for (const bool is_closed : {false, true}) {
      Shape shape;
      shape.influences_per_vertex = 1;
      add_fan(random, shape, size, is_closed, {});
      EXPECT_EQ(expect_fans(shape)[kComplex], size > kMaxFan);
    }
}

TEST(Fans, OfSplitAndCrackedLimbs) {
  Random random(1722);
  for (const double cracked : {0.0, 0.02, 0.5}) {
    Shape shape = make_limb(20, 9, 4);
    split_corners(random, shape, 0.3, cracked);
    const auto counts = expect_fans(shape);
    EXPECT_EQ(counts[kCracked] > 0, cracked > 0);
    EXPECT_EQ(counts[kClosed] > 50, cracked < 0.5);
  }
}

TEST(Fans, OfVerticesThatAreNotWelded) {
  Random random(1728);
  Shape shape = make_limb(20, 9, 4);
  split_corners(random, shape, 0.02, 0);
  EXPECT_EQ(expect_fans(shape)[kCracked], 0u);
  const auto counts = expect_fans(shape, false);
  EXPECT_GT(counts[kCracked], 20u);
  EXPECT_GT(counts[kClosed], 20u);
}

TEST(Fans, OfSoupsWithAllKinds) {
  Random random(1723);
  std::array<std::size_t, kFanKinds> sums{};
  for (int round = 0; round < 60; ++round) {
    const std::uint32_t joints = round % 2 ? 1 : 3;
    const auto counts =
        expect_fans(make_grid_soup(random, 2 + random.index(80), 2 + random.index(4), joints));
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += counts[k];
  }
  for (int round = 0; round < 20; ++round) {
    Shape shape = make_limb(10, 8, 3);
    tear(random, shape, 0.02 * round, 0.02);
    split_corners(random, shape, 0.1, 0.1);
    const auto counts = expect_fans(shape);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += counts[k];
  }
  for (int round = 0; round < 10; ++round)
    expect_fans(make_soup(random, 100, 5, 4, Weights::adversarial));
  for (const std::size_t sum : sums) EXPECT_GT(sum, 100u);
}

TEST(Fans, OfTrianglesThatFaceOppositeWays) {
  Shape shape;
  shape.influences_per_vertex = 1;
  Random random(1724);
  add_fan(random, shape, 6, true, {});
  std::swap(shape.triangles[2][0], shape.triangles[2][1]);
  EXPECT_EQ(expect_fans(shape)[kComplex], 3u);
}

TEST(Fans, KeepApartWhatMorphTargetsDisplaceApart) {
  Shape shape = make_morphing_limb(10, 6, 3);
  Random random(1725);
  split_corners(random, shape, 0.5, 0);
  const auto counts = expect_fans(shape);
  EXPECT_GT(counts[kOpen], 10u) << "the copies of displaced vertices have no displacement";
}

}  // namespace
}  // namespace pelt::test
