#include "tools/pelt/query/bounds_query.hpp"

#include <algorithm>

namespace pelt::tools::query {
namespace {

Box united(const Box& a, const Box& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace

BoundsQuery::BoundsQuery(std::span<const scene::Collider> colliders, const BoundsSettings& settings)
    : kind_(settings.kind) {
  for (std::uint32_t c = 0; c < colliders.size(); ++c) {
    if (settings.by == BoundsBy::joint) {
      add_joints(c, colliders[c].model);
    } else {
      bounded_.push_back({.collider = c});
    }
  }
}

QueryStats BoundsQuery::ask(std::span<Pose> poses) {
  QueryStats work;
  for (Bounded& bounded : bounded_) {
    Pose& pose = poses[bounded.collider];
    if (bounded.joint) {
      bounded.box = joint_box(pose, groups_[bounded.collider], *bounded.joint);
    } else {
      const Bounds found = kind_ == BoundsKind::exact ? tight_bounds(pose) : pelt::bounds(pose);
      bounded.box = found.box;
      bounded.sphere = found.sphere;
      work += found.stats;
    }
  }
  return work;
}

void BoundsQuery::keep(std::uint32_t) {
  for (Bounded& bounded : bounded_) {
    bounded.all_frames = united(bounded.all_frames, bounded.box);
    if (bounded.sphere)
      bounded.largest_radius = std::max(bounded.largest_radius, bounded.sphere->radius);
  }
}

void BoundsQuery::add_joints(std::uint32_t collider, const SkinnedModel& model) {
  groups_.push_back(group_by_joint(model));
  for (std::uint32_t j = 0; j < groups_.back().count(); ++j) {
    if (groups_.back().vertex_count(j) > 0) bounded_.push_back({.collider = collider, .joint = j});
  }
}

Box BoundsQuery::joint_box(const Pose& pose, const Groups& groups, std::uint32_t joint) const {
  return kind_ == BoundsKind::exact ? tight_group_bounds(pose, groups, joint)
                                    : group_bounds(pose, groups, joint);
}

}  // namespace pelt::tools::query
