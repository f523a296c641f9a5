#include <pelt/height_field.hpp>

#include "base/require.hpp"
#include "distance/answers.hpp"
#include "distance/pair_search.hpp"
#include "field/field_trees.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

namespace pelt {
namespace {

using detail::PosedTree;

/// Writes the contacts to `scratch`, in no particular order.
QueryStats find_contacts(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_field(posed, field.detail(), scratch.detail(), max_contacts);
}

MovingStats find_moving(const Motion& motion, const HeightField& field, Scratch& scratch,
                        const MovingOptions& options) {
  return detail::collide_moving_field(detail::step_of(motion).tree(), field.detail(),
                                      scratch.detail(), options);
}

}  // namespace

QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                   std::vector<Contact>& contacts, const Limits& limits) {
  const QueryStats stats =
      find_contacts(pose.detail().posed_tree(), field, scratch, limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch) {
  const QueryStats stats = find_contacts(pose.detail().posed_tree(), field, scratch, 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

MovingStats collide(const Motion& motion, const HeightField& field, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const MovingStats stats = find_moving(motion, field, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(const Motion& motion, const HeightField& field, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return find_moving(motion, field, scratch, options);
  });
}

QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch, Distance& result,
                    const DistanceOptions& options) {
  const PosedTree posed = pose.detail().posed_tree();
  return detail::least_distance(
      scratch.detail(), options, result,
      [&](std::uint32_t most, std::uint64_t) { return find_contacts(posed, field, scratch, most); },
      [&](const Contact& contact, QueryStats& work) {
        const detail::FoundTriangle found = detail::find_triangle(posed, contact.triangle_a, work);
        return detail::distance_touching(contact, found.corners,
                                         field.triangle(contact.triangle_b));
      },
      [&](const detail::SearchLimits& limits, detail::TriangleGap& gap) {
        return detail::closest_field_triangle(posed, field.detail(), scratch.detail(), limits, gap);
      });
}

}  // namespace pelt
