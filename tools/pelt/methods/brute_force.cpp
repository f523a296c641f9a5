#include "tools/pelt/methods/brute_force.hpp"

#include "geometry/triangle_pair.hpp"
#include "skin/skin.hpp"

#include <algorithm>

namespace pelt::methods {
namespace {

struct Box {
  Vec3 low, high;
};

struct PosedTriangle {
  detail::TriangleCorners corners;
  Box box;
  std::uint32_t triangle;
};

Vec3 low(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3 high(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

Box box_of(std::span<const Vec3> points) {
  Box box = {points[0], points[0]};
  for (const Vec3& p : points) box = {low(box.low, p), high(box.high, p)};
  return box;
}

/// Without branches, because it runs for all pairs.
bool boxes_meet(const Box& a, const Box& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
         (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

/// The triangles whose boxes overlap `where`; no others can touch anything inside it.
std::vector<PosedTriangle> triangles_in(const Box& where, std::span<const Triangle> triangles,
                                        std::span<const Vec3> positions) {
  std::vector<PosedTriangle> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& v = triangles[t];
    const detail::TriangleCorners corners = {positions[v[0]], positions[v[1]], positions[v[2]]};
    const Box box = box_of(corners);
    if (boxes_meet(box, where)) found.push_back({corners, box, t});
  }
  return found;
}

}  // namespace

BruteForceBody::BruteForceBody(const detail::SkinnedMesh& mesh)
    : mesh_(mesh), positions_(mesh.vertex_count()) {}

QueryStats BruteForceBody::update(const detail::Palette& palette) {
  detail::posed_vertices(mesh_, palette, positions_);
  QueryStats work;
  work.posed_vertices = positions_.size();
  return work;
}

QueryStats brute_force_collide(std::span<const Triangle> triangles_a,
                               std::span<const Vec3> positions_a,
                               std::span<const Triangle> triangles_b,
                               std::span<const Vec3> positions_b, std::vector<Contact>& contacts,
                               std::uint32_t max_contacts) {
  const auto all_a = triangles_in(box_of(positions_b), triangles_a, positions_a);
  const auto all_b = triangles_in(box_of(positions_a), triangles_b, positions_b);
  QueryStats stats;
  std::uint32_t found = 0;
  for (const PosedTriangle& a : all_a)
    for (const PosedTriangle& b : all_b) {
      if (!boxes_meet(a.box, b.box)) continue;
      if (found == max_contacts) {
        stats.cut_short = true;
        return stats;
      }
      ++stats.triangle_pairs;
      if (!detail::triangles_intersect(a.corners, b.corners)) continue;
      contacts.push_back(Contact{a.triangle, b.triangle});
      ++found;
    }
  return stats;
}

}  // namespace pelt::methods
