/// The queries of rays against a pose.

#include <pelt/ray.hpp>

#include "base/assert.hpp"
#include "model/model.hpp"
#include "model/triangle_places.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/valid_numbers.hpp"
#include "ray/ray_descent.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pelt {
namespace {

bool comes_before(const RayHit& a, const RayHit& b) {
  return a.t < b.t || (a.t == b.t && a.triangle < b.triangle);
}

}  // namespace

Ray segment(const Vec3& from, const Vec3& to) {
  return {from, {to.x - from.x, to.y - from.y, to.z - from.z}, 0, 1};
}

QueryStats cast(Pose& pose, std::span<const Ray> rays, std::span<RayHit> hits, Facing facing) {
  detail::require(hits.size() == rays.size(), "cast: give one hit for each ray");
  detail::require(detail::are_valid(rays), "cast: a ray has a NaN or infinite coordinate");
  return detail::first_hits(pose.detail().posed_tree(), rays, facing, hits);
}

QueryStats cast(Pose& pose, const Ray& ray, RayHit& result, Facing facing) {
  return cast(pose, std::span(&ray, 1), std::span(&result, 1), facing);
}

QueryStats cast_any(Pose& pose, std::span<const Ray> rays, std::span<bool> hit, Facing facing) {
  detail::require(hit.size() == rays.size(), "cast_any: give one answer for each ray");
  detail::require(detail::are_valid(rays), "cast_any: a ray has a NaN or infinite coordinate");
  return detail::any_hits(pose.detail().posed_tree(), rays, facing, hit);
}

QueryStats cast_all(Pose& pose, const Ray& ray, Scratch& scratch, std::vector<RayHit>& hits,
                    Facing facing) {
  detail::require(detail::is_valid(ray), "cast_all: the ray has a NaN or infinite coordinate");
  detail::Stack<RayHit>& found = scratch.detail().ray_hits;
  found.clear();
  const QueryStats work = detail::all_hits(pose.detail().posed_tree(), ray, facing, found);
  std::sort(found.begin(), found.end(), comes_before);
  hits.insert(hits.end(), found.begin(), found.end());
  return work;
}

namespace {

using detail::Node;
using detail::Tree;

/// Adds `share` to the joint's entry among the shares from `begin` on.
void add_share(std::uint32_t joint, float share, std::size_t begin,
               std::vector<JointShare>& shares) {
  const auto known = std::find_if(shares.begin() + static_cast<std::ptrdiff_t>(begin), shares.end(),
                                  [=](const JointShare& s) { return s.joint == joint; });
  if (known == shares.end()) {
    shares.push_back({joint, share});
  } else {
    known->share += share;
  }
}

}  // namespace

QueryStats influences_at(const SkinnedModel& model, const RayHit& hit,
                         std::vector<JointShare>& shares) {
  const Tree& tree = model.detail().tree;
  const std::uint32_t place = detail::Access::numbers(hit.location)[0];
  detail::require(place < tree.triangle_count() && tree.triangle_ids[place] == hit.triangle,
                  "influences_at: the hit belongs to another model, or to none");
  const Node& node = tree.nodes[node_of_triangle(tree, place)];
  std::array<std::uint32_t, 3> vertices;
  std::size_t influences = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k] = node.first_vertex + tree.corners[place][k] / detail::kFloatsPerVertex;
    influences += tree.influence_begin[vertices[k] + 1] - tree.influence_begin[vertices[k]];
  }
  detail::reserve_more(shares, influences);  // if memory runs out, the list has not changed
  const std::size_t begin = shares.size();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = vertices[k];
    for (std::uint32_t i = tree.influence_begin[vertex]; i < tree.influence_begin[vertex + 1]; ++i)
      if (const float share = hit.barycentrics[k] * tree.weights[i]; share > 0)
        add_share(tree.joints[i], share, begin, shares);
  }
  std::sort(shares.begin() + static_cast<std::ptrdiff_t>(begin), shares.end(),
            [](const JointShare& a, const JointShare& b) {
              return a.share > b.share || (a.share == b.share && a.joint < b.joint);
            });
  return {};
}

}  // namespace pelt
