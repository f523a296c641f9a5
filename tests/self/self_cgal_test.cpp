/// Self-contacts against `CGAL::Polygon_mesh_processing::self_intersections`.
///
/// Both have one rule for triangles that share a corner or an edge. The answers differ as follows:
/// - CGAL does not accept collapsed triangles. They are left out of both answers.
/// - CGAL's meshes are manifold, so it sees no duplicate triangles, no edge of three triangles, and
///   no two triangles that share two corners but no edge. The meshes here have none of these.
/// - For CGAL, corners are shared if they are one vertex of the mesh, wherever it is. The meshes
///   here have no cracks.

#include <pelt/self_filter.hpp>

#include "scenes/creature.hpp"
#include "self_brute_force.hpp"
#include "support/animated_character.hpp"
#include "support/pinned_shapes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace pelt::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 cgal(const Vec3& p) { return {p.x, p.y, p.z}; }

bool has_collapsed(const detail::TriangleCorners& t) {
  return CGAL::collinear(cgal(t[0]), cgal(t[1]), cgal(t[2]));
}

/// A mesh with the posed positions of surface vertices. Empty if it is not manifold.
Mesh make_mesh(const SurfaceTriangles& triangles) {
  Mesh mesh;
  std::map<std::uint32_t, Mesh::Vertex_index> vertices;
  for (const detail::SurfaceTriangle& t : triangles) {
    std::array<Mesh::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [known, is_new] = vertices.try_emplace(t.vertices[k]);
      if (is_new) known->second = mesh.add_vertex(cgal(t.corners[k]));
      corners[k] = known->second;
    }
    if (mesh.add_face(corners[0], corners[1], corners[2]) == Mesh::null_face()) return {};
  }
  return mesh;
}

std::vector<Contact> cgal_contacts(const SurfaceTriangles& triangles) {
  const Mesh mesh = make_mesh(triangles);
  EXPECT_EQ(mesh.number_of_faces(), triangles.size()) << "the mesh is not manifold";
  std::vector<Mesh::Face_index> faces;
  for (const Mesh::Face_index face : mesh.faces())
    if (!has_collapsed(triangles[face].corners)) faces.push_back(face);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(faces, mesh, std::back_inserter(pairs));
  std::vector<Contact> contacts;
  for (const auto& [s, t] : pairs)
    contacts.push_back({std::min<std::uint32_t>(s, t), std::max<std::uint32_t>(s, t)});
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

/// Counts of what was compared.
struct Compared {
  std::size_t contacts = 0, collapsed = 0, neighbours = 0;
};

bool share_vertex(const detail::SurfaceTriangle& s, const detail::SurfaceTriangle& t) {
  return std::find_first_of(s.vertices.begin(), s.vertices.end(), t.vertices.begin(),
                            t.vertices.end()) != s.vertices.end();
}

void compare(Pose& pose, const SurfaceTriangles& triangles, Compared& compared) {
  Scratch scratch;
  std::vector<Contact> found = self_contacts_of(pose, *build_self_filter(pose.model()), scratch);
  compared.collapsed += std::erase_if(found, [&](const Contact& c) {
    return has_collapsed(triangles[c.triangle_a].corners) ||
           has_collapsed(triangles[c.triangle_b].corners);
  });
  ASSERT_EQ(found, cgal_contacts(triangles));
  compared.contacts += found.size();
  for (const Contact& c : found)
    compared.neighbours += share_vertex(triangles[c.triangle_a], triangles[c.triangle_b]);
}

TEST(SelfCgal, VerticesOnSmallGrids) {
  const std::pair<std::uint32_t, std::vector<Triangle>> surfaces[] = {
      {4, tetrahedron()}, {6, octahedron()}, {35, torus(7, 5)}};
  Random random(1760);
  Compared compared;
  for (int round = 0; round < 600 && !HasFatalFailure(); ++round) {
    const auto& [vertex_count, surface] = surfaces[round % 3];
    const Shape shape = make_pinned(vertex_count, surface);
    Pose pose(*build_model(shape.view()));
    const std::uint32_t size = 2 + random.index(6);
    std::vector<Vec3> positions(vertex_count);
    for (Vec3& p : positions)
      p = {static_cast<float>(random.index(size)), static_cast<float>(random.index(size)),
           static_cast<float>(random.index(3))};
    ASSERT_TRUE(pose.set_palette(pin(positions)));
    compare(pose, posed_triangles(shape.view(), surface_vertices(shape), pose), compared);
  }
  EXPECT_GT(compared.contacts, 50'000u);
  EXPECT_GT(compared.neighbours, 10'000u);
  EXPECT_GT(compared.collapsed, 5'000u);
}

TEST(SelfCgal, FoldedLimbs) {
  Random random(1761);
  Compared compared;
  const Shape shape = make_limb(30, 9, 6);
  Pose pose(*build_model(shape.view()));
  for (int round = 0; round < 40 && !HasFatalFailure(); ++round) {
    ASSERT_TRUE(pose.set_palette(bend_limb(random, 6, random.uniform(0.5, 1.6), {})));
    compare(pose, posed_triangles(shape.view(), surface_vertices(shape), pose), compared);
  }
  EXPECT_GT(compared.contacts, 1000u);
  EXPECT_GT(compared.neighbours, 50u);
}

/// Compares frames of all clips. With `reversed`, each joint has the matrix of another joint.
void compare_frames(AnimatedCharacter& character, bool reversed, Compared& compared) {
  const asset::Asset& asset = character.asset;
  const std::vector<std::uint32_t> surface = surface_vertices(asset.mesh());
  Pose& pose = character.pose;
  for (const asset::Clip& clip : asset.clips) {
    std::vector<Matrix4> palette = character.palette(&clip, clip.duration / 3);
    if (reversed) std::reverse(palette.begin(), palette.end());
    ASSERT_TRUE(pose.set_palette(palette));
    compare(pose, posed_triangles(asset.mesh(), surface, pose), compared);
  }
}

TEST(SelfCgal, GeneratedCharacter) {
  Compared compared;
  AnimatedCharacter dwarf(*scenes::make_creature(scenes::kDwarf));
  compare_frames(dwarf, true, compared);
  EXPECT_GT(compared.contacts, 100u);
}

using SelfCgalOfModels = OfSharedModels<>;

TEST_P(SelfCgalOfModels, RealCharacter) {
  Compared compared;
  compare_frames(*character, false, compared);
  EXPECT_GT(compared.contacts, 5000u);
}

INSTANTIATE_TEST_SUITE_P(Shared, SelfCgalOfModels, testing::Values("human.glb"), kStemOfModel);

}  // namespace
}  // namespace pelt::test
