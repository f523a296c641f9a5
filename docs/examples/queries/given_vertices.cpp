#include <pelt/collide.hpp>

// A mesh without joints: its vertices come from a simulation or a file.
pelt::Result<pelt::SkinnedModel> cloth(std::span<const pelt::Vec3> rest,
                                       std::span<const pelt::Triangle> triangles) {
  pelt::SkinnedMeshView mesh;
  mesh.rest_positions = rest;
  mesh.triangles = triangles;
  return pelt::build_model(mesh);
}

// All vertices of this frame, in the frame of the other pose.
bool touches(pelt::Pose& cloth, std::span<const pelt::Vec3> vertices, pelt::Pose& body,
             pelt::Scratch& scratch) {
  return cloth.set_vertices(vertices) && intersects(cloth, body, scratch).answer;
}

// Small details on top of the joints, each within the cap of its vertex. The pose borrows them.
bool add_wrinkles(pelt::Pose& body, std::span<const pelt::Vec3> offsets) {
  return body.set_offsets(offsets) && check_offsets(body) == 0;
}
