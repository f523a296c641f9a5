#include "bench/brute_force.hpp"

#include "geometry/triangle_pair.hpp"
#include "pose/skin.hpp"

#include <algorithm>

namespace pelt::bench {
namespace {

struct Box {
  Vec3 low, high;
};

using Corners = detail::TriangleCorners;

std::vector<Corners> posed_triangles(std::span<const Triangle> triangles,
                                     std::span<const Vec3> positions) {
  std::vector<Corners> corners;
  corners.reserve(triangles.size());
  for (const Triangle& t : triangles)
    corners.push_back({positions[t[0]], positions[t[1]], positions[t[2]]});
  return corners;
}

Box box_of(const Corners& c) {
  return {{std::min({c[0].x, c[1].x, c[2].x}), std::min({c[0].y, c[1].y, c[2].y}),
           std::min({c[0].z, c[1].z, c[2].z})},
          {std::max({c[0].x, c[1].x, c[2].x}), std::max({c[0].y, c[1].y, c[2].y}),
           std::max({c[0].z, c[1].z, c[2].z})}};
}

std::vector<Box> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& corners : triangles) boxes.push_back(box_of(corners));
  return boxes;
}

/// Without branches: this is asked of all pairs.
bool boxes_meet(const Box& a, const Box& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
         (b.low.y <= a.high.y) & (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
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
  const std::vector<Corners> a = posed_triangles(triangles_a, positions_a);
  const std::vector<Corners> b = posed_triangles(triangles_b, positions_b);
  const std::vector<Box> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  QueryStats stats;
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (!boxes_meet(boxes_a[i], boxes_b[j])) continue;
      if (found == max_contacts) {
        stats.cut_short = true;
        return stats;
      }
      ++stats.triangle_pairs;
      if (!detail::triangles_intersect(a[i], b[j])) continue;
      contacts.push_back(Contact{i, j});
      ++found;
    }
  return stats;
}

QueryStats collide(const BruteForceBody& a, const BruteForceBody& b, detail::Scratch&,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  return brute_force_collide(a.triangles(), a.positions(), b.triangles(), b.positions(), contacts,
                             max_contacts);
}

}  // namespace pelt::bench
