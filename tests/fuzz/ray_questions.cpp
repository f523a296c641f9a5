#include "fuzz/fuzzed_operands.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "ray/ray_oracle.hpp"
#include "support/require.hpp"

#include <pelt/ray.hpp>

#include <cmath>

namespace pelt::test {
namespace {

Goal ray_hits("cast: several hits"), ray_misses("cast: a miss"), shares_asked("influences_at");

void check_shares(const Question& q, const RayHit& hit) {
  std::vector<JointShare> shares;
  influences_at(q.a.pose.model(), hit, shares);
  float sum = 0;
  for (const JointShare& share : shares) {
    require(share.share > 0 && share.joint < q.a.shape.joint_count, "a share of influences_at");
    sum += share.share;
  }
  require(std::abs(sum - 1) < 1e-5f, "the sum of the shares");
  shares_asked.reach();
}

}  // namespace

void ask_ray(Question& q) {
  const Ray ray = make_ray(q.bytes, q.a);
  const auto facing = static_cast<Facing>(q.bytes.index(3));
  const std::vector<RayHit> expected = RayOracle(q.a.shape.triangles, q.a.pose).all(ray, facing);
  std::vector<RayHit> hits;
  cast_all(q.a.pose, ray, q.scratch, hits, facing);
  require(hits.size() == expected.size(), "cast_all");
  for (std::size_t i = 0; i < hits.size(); ++i)
    require(without_location(hits[i]) == expected[i], "a hit of cast_all");
  RayHit first;
  cast(q.a.pose, ray, first, facing);
  require(without_location(first) == (expected.empty() ? RayHit() : expected[0]), "cast");
  bool any = false;
  cast_any(q.a.pose, std::span(&ray, 1), std::span(&any, 1), facing);
  require(any == !expected.empty(), "cast_any");
  if (first) check_shares(q, first);
  ray_hits.reach(hits.size() > 1);
  ray_misses.reach(hits.empty());
}

}  // namespace pelt::test
