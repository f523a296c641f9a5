/// FCL, the Flexible Collision Library: continuous collision detection of two meshes, by a binary
/// tree of boxes over the whole step, refitted bottom-up.
///
/// `beginUpdateModel` bounds the motion from the positions of the update before. The traversal is
/// called directly, because `fcl::continuousCollide` only accepts rigid motion. The leaf solves
/// cubics in floating point, for six pairs of a vertex and a face and nine pairs of edges, with
/// tolerances. It finds events: triangles that intersect at the start of the step are found only if
/// a vertex meets a face, or an edge an edge, later. Double precision, because the solver of cubics
/// reads the sign from the bytes of a double.
///
/// The tolerances are absolute: in metres, coefficients of the cubics of small triangles are below
/// them, and answers are often wrong. In millimetres, they are nearly right. Positions are
/// multiplied by a scale, therefore.
#include "evaluation/peers/adapters.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>
#include <fcl/math/bv/utility.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_continuous_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

namespace pelt::peers {
namespace {

using Mesh = fcl::BVHModel<fcl::AABBd>;

void to_fcl(std::span<const Vec3> positions, double scale, std::vector<fcl::Vector3d>& out) {
  out.clear();
  for (const Vec3& p : positions) out.emplace_back(scale * p.x, scale * p.y, scale * p.z);
}

class FclMoving final : public MovingMeshMethod {
 public:
  explicit FclMoving(double scale) : scale_(scale) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    std::vector<fcl::Triangle> corners;
    for (const Triangle& t : triangles) corners.emplace_back(t[0], t[1], t[2]);
    to_fcl(rest, scale_, positions_);
    auto mesh = std::make_unique<Mesh>();
    mesh->beginModel();
    mesh->addSubModel(positions_, corners);
    mesh->endModel();
    bodies_.push_back(std::move(mesh));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    constexpr bool kRefit = true, kBottomUp = true;
    to_fcl(positions, scale_, positions_);
    bodies_[body]->beginUpdateModel();
    bodies_[body]->updateSubModel(positions_);
    bodies_[body]->endUpdateModel(kRefit, kBottomUp);
  }

  void collide_moving(std::uint32_t a, std::uint32_t b, std::uint32_t max_pairs,
                      std::vector<TimedPair>& pairs) override {
    const fcl::Transform3d identity = fcl::Transform3d::Identity();
    fcl::detail::MeshContinuousCollisionTraversalNode<fcl::AABBd> node;
    initialize(node, *bodies_[a], identity, *bodies_[b], identity,
               fcl::CollisionRequestd(max_pairs));
    fcl::detail::collide(&node);
    for (const auto& pair : node.pairs)
      pairs.push_back({{static_cast<std::uint32_t>(pair.id1), static_cast<std::uint32_t>(pair.id2)},
                       pair.collision_time});
  }

 private:
  double scale_;
  std::vector<std::unique_ptr<Mesh>> bodies_;
  std::vector<fcl::Vector3d> positions_;
};

}  // namespace

std::unique_ptr<MovingMeshMethod> make_fcl_moving(double scale) {
  return std::make_unique<FclMoving>(scale);
}

}  // namespace pelt::peers
