#include "bounds/box_of_triangles.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "support/require.hpp"
#include "support/values.hpp"

#include <pelt/bounds.hpp>
#include <pelt/pose.hpp>

#include <gmpxx.h>

#include <algorithm>

namespace pelt::test {
namespace {

Goal bounds_asked("bounds"), bounds_of_nodes("bounds of a tree of several nodes"),
    groups_asked("group_triangles: a group with vertices"),
    empty_group("group_triangles: an empty group"), joint_groups_asked("group_by_joint"),
    farthest_asked("farthest_vertex"), farthest_tie("farthest_vertex: several corners");

void check_bounds_of(const FuzzedBody& body, const Bounds& found, const Box& exact) {
  require(encloses(found.box, exact), "the box of bounds");
  require(encloses(found.sphere, body.shape.triangles, body.posed), "the sphere of bounds");
}

void check_group(Question& q, const VertexGroups& groups, std::uint32_t group, const Box& exact) {
  const Box loose = group_box(q.a.pose, groups, group);
  require(same_bits(exact_group_box(q.a.pose, groups, group), exact), "exact_group_bounds");
  if (groups.vertex_count(group) > 0) return require(encloses(loose, exact), "group_bounds");
  require(same_bits(loose, nothing()) && same_bits(exact, nothing()), "an empty group");
}

/// The joint with the largest weight of a vertex; of several, the lowest.
std::uint32_t main_joint(const Shape& shape, std::uint32_t vertex) {
  const std::size_t row = std::size_t{vertex} * shape.influences_per_vertex;
  std::vector<float> weights(shape.joint_count);
  for (std::size_t i = row; i < row + shape.influences_per_vertex; ++i)
    weights[shape.joints[i]] += shape.weights[i];
  return static_cast<std::uint32_t>(std::max_element(weights.begin(), weights.end()) -
                                    weights.begin());
}

void check_joint_groups(Question& q) {
  const VertexGroups groups = group_by_joint(q.a.pose.model());
  std::vector<Box> expected(q.a.shape.joint_count, nothing());
  for (const Triangle& triangle : q.a.shape.triangles)
    for (const std::uint32_t v : triangle)
      include({q.a.posed[v].x + 0.0f, q.a.posed[v].y + 0.0f, q.a.posed[v].z + 0.0f},
              expected[main_joint(q.a.shape, v)]);
  require(groups.count() == expected.size(), "the number of groups by joint");
  for (std::uint32_t g = 0; g < groups.count(); ++g) check_group(q, groups, g, expected[g]);
  joint_groups_asked.reach();
}

using BigVector = std::array<mpq_class, 3>;

BigVector big_vector(const Vec3& v) {
  return {mpq_class(double{v.x}), mpq_class(double{v.y}), mpq_class(double{v.z})};
}

mpq_class dot_of(const BigVector& a, const Vec3& b) {
  const BigVector v = big_vector(b);
  return a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
}

}  // namespace

void ask_bounds(Question& q) {
  require(check_bounds(q.a.pose).empty(), "bounds that do not enclose");
  const Box exact = box_of(q.a.shape.triangles, q.a.posed);
  check_bounds_of(q.a, bounds_of(q.a.pose, q.bytes.index(4)), exact);
  const Bounds tight = exact_bounds_of(q.a.pose);
  check_bounds_of(q.a, tight, exact);
  require(same_bits(tight.box, exact), "exact_bounds");
  require(same_bits(bounds_of(q.a.pose, 9).box, exact), "bounds of all levels");
  bounds_asked.reach();
  bounds_of_nodes.reach(q.a.triangle_count() > 128);
}

void ask_groups(Question& q) {
  std::vector<std::uint32_t> labels;
  for (std::uint32_t t = 0; t < q.a.triangle_count(); ++t) {
    const std::uint32_t label = q.bytes.index(5);
    labels.push_back(label == 4 ? kNoGroup : label % q.a.triangle_count());
  }
  const Result<VertexGroups> groups = group_triangles(q.a.pose.model(), labels);
  require(static_cast<bool>(groups), "group_triangles refuses labels");
  for (std::uint32_t g = 0; g < groups->count(); ++g) {
    std::vector<Triangle> triangles;
    for (std::uint32_t t = 0; t < labels.size(); ++t)
      if (labels[t] == g) triangles.push_back(q.a.shape.triangles[t]);
    check_group(q, *groups, g, box_of(triangles, q.a.posed));
    (triangles.empty() ? empty_group : groups_asked).reach();
  }
  check_joint_groups(q);
}

void ask_farthest(Question& q) {
  const Vec3 direction = q.bytes.point();
  if (direction == Vec3()) return;
  const BigVector exact_direction = big_vector(direction);
  FarthestVertex expected;
  mpq_class most;
  int ties = 0;
  for (std::uint32_t t = 0; t < q.a.triangle_count(); ++t)
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const Vec3 position = q.a.corners(t)[corner];
      const mpq_class along = dot_of(exact_direction, position);
      ties += expected && along == most;
      if (expected && along <= most) continue;
      expected = {t, corner, position};
      most = along;
      ties = 0;
    }
  FarthestVertex found;
  farthest_vertex(q.a.pose, direction, found);
  require(found.triangle == expected.triangle && found.corner == expected.corner,
          "farthest_vertex");
  require(found.position == expected.position, "the position of farthest_vertex");
  farthest_asked.reach();
  farthest_tie.reach(ties > 0);
}

}  // namespace pelt::test
