/// The queries of a pose, and of a motion, against regions.

#include <pelt/solid.hpp>

#include "base/assert.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "solid/prepared_region.hpp"
#include "solid/region_descent.hpp"

#include <cstddef>

namespace pelt {
namespace {

using detail::PreparedRegion;
using detail::RegionAnswer;
using detail::RegionGoal;

RegionAnswer descend(Pose& pose, const PreparedRegion& region, Scratch& scratch, RegionGoal goal) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  return region.is_capsule
             ? detail::descend_in_capsule(posed, region.capsule, scratch.detail(), goal)
             : detail::descend_in_faces(posed, region.faces, scratch.detail(), goal);
}

Placement placement_of(const RegionAnswer& answer) {
  if (!answer.touches) return Placement::outside;
  return answer.leaves ? Placement::partly : Placement::inside;
}

void append(detail::Stack<std::uint32_t>& found, std::vector<std::uint32_t>& triangles) {
  triangles.insert(triangles.end(), found.begin(), found.end());
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

QueryStats classify(Pose& pose, const Region& region, Scratch& scratch, Placement& result) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionGoal::placement);
  result = placement_of(answer);
  return answer.work;
}

QueryStats classify(std::span<Pose* const> poses, const Region& region, Scratch& scratch,
                    std::span<Placement> results) {
  detail::require(poses.size() == results.size(), "classify: give one result for each pose");
  const PreparedRegion prepared(region);
  QueryStats work;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RegionAnswer answer = descend(*poses[i], prepared, scratch, RegionGoal::placement);
    results[i] = placement_of(answer);
    work += answer.work;
  }
  return work;
}

QueryStats find_triangles(Pose& pose, const Region& region, Scratch& scratch,
                          TrianglesInRegion& triangles) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionGoal::triangles);
  detail::Stack<std::uint32_t>& intersecting = scratch.detail().touching;
  detail::Stack<std::uint32_t>& inside = scratch.detail().inside;
  detail::sort_numbers(intersecting, scratch.detail().sorting_numbers);
  detail::sort_numbers(inside, scratch.detail().sorting_numbers);
  // If memory runs out, neither list has changed.
  detail::reserve_more(triangles.intersecting, intersecting.size());
  detail::reserve_more(triangles.inside, inside.size());
  append(intersecting, triangles.intersecting);
  append(inside, triangles.inside);
  return answer.work;
}

QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                   std::vector<std::uint32_t>& triangles) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionGoal::triangles);
  detail::Stack<std::uint32_t>& found = scratch.detail().touching;
  detail::sort_numbers(found, scratch.detail().sorting_numbers);
  append(found, triangles);
  return answer.work;
}

YesNo intersects(Pose& pose, const Region& region, Scratch& scratch) {
  const RegionAnswer answer = descend(pose, PreparedRegion(region), scratch, RegionGoal::touch);
  return detail::yes_or_no(answer.touches, answer.work);
}

namespace {

/// Writes the triangles to `scratch`, in no particular order.
MovingStats find_moving(const Motion& motion, const Region& region, Scratch& scratch,
                        const MovingOptions& options) {
  const detail::Step step = detail::step_of(motion);
  const detail::PreparedRegion prepared(region);
  return prepared.is_capsule ? detail::descend_moving_in_capsule(step.tree(), prepared.capsule,
                                                                 scratch.detail(), options)
                             : detail::descend_moving_in_faces(step.tree(), prepared.faces,
                                                               scratch.detail(), options);
}

}  // namespace

MovingStats collide(const Motion& motion, const Region& region, Scratch& scratch,
                    std::vector<RegionEntry>& entries, const MovingOptions& options) {
  const MovingStats stats = find_moving(motion, region, scratch, options);
  detail::Stack<MovingContact>& found = scratch.detail().moving;
  detail::sort_contacts(found, scratch.detail().sorting_moving);
  detail::reserve_more(entries, found.size());
  for (const MovingContact& c : found)
    entries.push_back({c.contact.triangle_a, c.time, c.at_start});
  return stats;
}

YesNo intersects(const Motion& motion, const Region& region, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return find_moving(motion, region, scratch, options);
  });
}

}  // namespace pelt
