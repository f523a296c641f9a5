#include "fuzz/exact_region.hpp"
#include "fuzz/fuzzed_operands.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "solid/region_oracle.hpp"
#include "support/require.hpp"
#include "support/values.hpp"

namespace pelt::test {
namespace {

Goal regions_touched[] = {Goal("find_triangles: half-space"),   Goal("find_triangles: box"),
                          Goal("find_triangles: oriented box"), Goal("find_triangles: polyhedron"),
                          Goal("find_triangles: sphere"),       Goal("find_triangles: capsule")};
Goal region_missed("classify: outside"), region_crossed("classify: partly"),
    region_around("classify: inside");

/// The library's definition for one triangle against rational numbers.
void check_definition(const Region& region, const FuzzedBody& body,
                      const TrianglesInRegion& expected) {
  const ExactRegion exact_region(region);
  TrianglesInRegion found;
  for (std::uint32_t t = 0; t < body.triangle_count(); ++t) {
    if (exact_region.touches(body.corners(t))) found.intersecting.push_back(t);
    if (exact_region.has_inside(body.corners(t))) found.inside.push_back(t);
  }
  require(found.intersecting == expected.intersecting, "a triangle that touches a region");
  require(found.inside == expected.inside, "a triangle inside a region");
}

}  // namespace

void ask_region(Question& q) {
  const Region region = make_region(q.bytes, q.a);
  const TrianglesInRegion expected = brute_force(region, q.a.shape.triangles, q.a.posed);
  if (q.a.is_small()) check_definition(region, q.a, expected);
  TrianglesInRegion found;
  find_triangles(q.a.pose, region, q.scratch, found);
  require(found.intersecting == expected.intersecting && found.inside == expected.inside,
          "find_triangles");
  std::vector<std::uint32_t> touching;
  collide(q.a.pose, region, q.scratch, touching);
  require(touching == expected.intersecting, "collide with a region");
  require(static_cast<bool>(intersects(q.a.pose, region, q.scratch)) == !touching.empty(),
          "intersects of a region");
  const Placement placement = placement_of(q.a.pose, region, q.scratch);
  require(placement == placement_of(expected, q.a.triangle_count()), "classify");
  regions_touched[region.index()].reach(!touching.empty());
  region_missed.reach(placement == Placement::outside);
  region_crossed.reach(placement == Placement::partly);
  region_around.reach(placement == Placement::inside);
}

}  // namespace pelt::test
