#include <pelt/region.hpp>

#include "base/assert.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/sort_numbers.hpp"
#include "region/prepared_region.hpp"
#include "region/region_descent.hpp"

#include <cstddef>

namespace pelt {
namespace {

using detail::PreparedRegion;
using detail::RegionAnswer;
using detail::RegionWish;

RegionAnswer descend(Pose& pose, const PreparedRegion& region, Scratch& scratch, RegionWish wish) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  return region.is_capsule
             ? detail::descend_in_capsule(posed, region.capsule, scratch.detail(), wish)
             : detail::descend_in_faces(posed, region.faces, scratch.detail(), wish);
}

Placement placement_of(const RegionAnswer& answer) {
  if (!answer.touches) return Placement::outside;
  return answer.leaves ? Placement::partly : Placement::inside;
}

void move_sorted(detail::Stack<std::uint32_t>& found, Scratch& scratch,
                 std::vector<std::uint32_t>& triangles) {
  detail::sort_numbers(found, scratch.detail().sorting_numbers);
  triangles.assign(found.begin(), found.end());
}

}  // namespace

const char* name_of(Placement placement) {
  switch (placement) {
    case Placement::outside:
      return "outside";
    case Placement::partly:
      return "partly";
    case Placement::inside:
      return "inside";
  }
  PELT_ASSERT(false);
  return "";
}

Classified classify(Pose& pose, const Region& region, Scratch& scratch) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionWish::placement);
  return {placement_of(answer), answer.work};
}

QueryStats classify(std::span<Pose* const> poses, const Region& region, Scratch& scratch,
                    std::span<Placement> placements) {
  PELT_ASSERT(poses.size() == placements.size());
  const PreparedRegion prepared(region);
  QueryStats work;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RegionAnswer answer = descend(*poses[i], prepared, scratch, RegionWish::placement);
    placements[i] = placement_of(answer);
    work += answer.work;
  }
  return work;
}

QueryStats find_triangles(Pose& pose, const Region& region, Scratch& scratch,
                          TrianglesInRegion& triangles) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionWish::triangles);
  move_sorted(scratch.detail().touching, scratch, triangles.touching);
  move_sorted(scratch.detail().inside, scratch, triangles.inside);
  return answer.work;
}

QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                   std::vector<std::uint32_t>& triangles) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionWish::triangles);
  detail::Stack<std::uint32_t>& found = scratch.detail().touching;
  detail::sort_numbers(found, scratch.detail().sorting_numbers);
  triangles.insert(triangles.end(), found.begin(), found.end());
  return answer.work;
}

bool intersects(Pose& pose, const Region& region, Scratch& scratch) {
  return descend(pose, PreparedRegion(region), scratch, RegionWish::touch).touches;
}

}  // namespace pelt
