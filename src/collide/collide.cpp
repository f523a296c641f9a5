/// The queries of two poses, still and moving, and the same of poses whose nodes are all open.

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>

#include "base/assert.hpp"
#include "collide/collide_trees.hpp"
#include "collide/eager.hpp"
#include "motion/moving_tree.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/sort_contacts.hpp"

#include <optional>

namespace pelt {
namespace {

/// Sets `first` to the lowest pair of triangles that intersect at time 0. If there is none, `first`
/// is empty.
QueryStats find_at_start(const detail::PosedTree& a, const detail::PosedTree& b,
                         detail::Scratch& scratch, std::optional<MovingContact>& first) {
  std::optional<Contact> lowest;
  const QueryStats work = lowest_contact(a, b, scratch, lowest);
  first.reset();
  if (lowest) first = {*lowest, 0, true, {}, {}};
  return work;
}

MovingStats find_moving(const Motion& a, const Motion& b, Scratch& scratch,
                        const MovingOptions& options) {
  detail::require_steps(a, b);
  const detail::Step step_a = detail::step_of(a), step_b = detail::step_of(b);
  return collide_moving_trees(step_a.tree(), step_b.tree(), scratch.detail(), options);
}

}  // namespace

QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits) {
  detail::require(&a != &b, "collide: `a` and `b` are the same pose; give two poses");
  const QueryStats stats = detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(),
                                                 scratch.detail(), limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(Pose& a, Pose& b, Scratch& scratch) {
  detail::require(&a != &b, "intersects: `a` and `b` are the same pose; give two poses");
  const QueryStats stats =
      detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(), 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

MovingStats& MovingStats::operator+=(const MovingStats& other) {
  QueryStats::operator+=(other);
  double_pairs += other.double_pairs;
  exact_pairs += other.exact_pairs;
  return *this;
}

MovingStats collide(const Motion& a, const Motion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const MovingStats stats = find_moving(a, b, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(const Motion& a, const Motion& b, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return find_moving(a, b, scratch, options);
  });
}

MovingStats first_contact(const Motion& a, const Motion& b, Scratch& scratch,
                          std::optional<MovingContact>& first, const MovingOptions& options) {
  detail::require_steps(a, b);
  const detail::Step step_a = detail::step_of(a), step_b = detail::step_of(b);
  MovingStats work;
  if (!options.leave_out_start) {
    work.QueryStats::operator+=(find_at_start(step_a.from, step_b.from, scratch.detail(), first));
    if (first) return work;
  }
  work += first_contact_of_trees(step_a.tree(), step_b.tree(), scratch.detail(), first);
  return work;
}

namespace detail {

EagerPose::EagerPose(const Tree& tree) : tree_(tree), instance_(tree) { close_all(); }

void EagerPose::copy(const Instance& posed) {
  instance_.palette = posed.palette;
  instance_.given = posed.given;
  close_all();
}

Result<void> EagerPose::set_morph_weights(std::span<const float> weights) {
  return instance_.palette.set_morph_weights(weights);
}

Result<void> EagerPose::set_palette(std::span<const Matrix4> palette) {
  Result<void> taken = instance_.palette.set(palette);
  if (!taken) return taken;
  instance_.given = {};
  close_all();
  return {};
}

void EagerPose::close_all() {
  arena_.clear();
  instance_.root_box.known = false;
  instance_.opened = OpenedNodes(static_cast<std::uint32_t>(tree_.nodes.size()), arena_);
}

QueryStats EagerPose::open_all() { return detail::open_all(posed_tree()); }

PosedTree EagerPose::posed_tree() { return instance_.posed_tree(tree_, no_bounds_, arena_); }

namespace {

Step step_of(const EagerMotion& motion) {
  return {motion.from.posed_tree(), motion.to.posed_tree()};
}

}  // namespace

QueryStats collide(EagerPose& a, EagerPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits) {
  const QueryStats stats =
      collide_trees(a.posed_tree(), b.posed_tree(), scratch, limits.max_contacts);
  append_sorted(scratch, contacts);
  return stats;
}

MovingStats collide(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const Step step_a = step_of(a), step_b = step_of(b);
  const MovingStats stats = collide_moving_trees(step_a.tree(), step_b.tree(), scratch, options);
  append_sorted(scratch, contacts);
  return stats;
}

MovingStats first_contact(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first) {
  const Step step_a = step_of(a), step_b = step_of(b);
  MovingStats work;
  work.QueryStats::operator+=(find_at_start(step_a.from, step_b.from, scratch, first));
  if (!first) work += first_contact_of_trees(step_a.tree(), step_b.tree(), scratch, first);
  return work;
}

}  // namespace detail
}  // namespace pelt
