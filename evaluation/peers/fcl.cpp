/// FCL, the Flexible Collision Library: a binary tree of boxes, refitted bottom-up.
///
/// AABB is the fastest kind of bounding volume here: refitting oriented boxes takes 8 to 30 times
/// as long. In single precision, queries take a third less time than in double, and give the same
/// answers. `beginReplaceModel` refits; `beginUpdateModel` would bound the motion between two
/// frames. The narrow phase is FCL's own, because its traversal accepts no other. The traversal is
/// called directly, because `fcl::collide` first copies both meshes with their trees. Contact
/// points are not requested, and the traversal stops at the given number of contacts.

#include "evaluation/peers/adapters.hpp"

#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>
#include <fcl/math/bv/utility.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_continuous_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

namespace pelt::peers {
namespace {

template <typename Scalar>
using Mesh = fcl::BVHModel<fcl::AABB<Scalar>>;

template <typename Scalar>
using Points = std::vector<fcl::Vector3<Scalar>>;

template <typename Scalar>
void to_fcl(std::span<const Vec3> positions, Scalar scale, Points<Scalar>& out) {
  out.clear();
  for (const Vec3& p : positions) out.emplace_back(scale * p.x, scale * p.y, scale * p.z);
}

template <typename Scalar>
std::unique_ptr<Mesh<Scalar>> build_mesh(std::span<const Triangle> triangles,
                                         const Points<Scalar>& positions) {
  std::vector<fcl::Triangle> corners;
  for (const Triangle& t : triangles) corners.emplace_back(t[0], t[1], t[2]);
  auto mesh = std::make_unique<Mesh<Scalar>>();
  mesh->beginModel();
  mesh->addSubModel(positions, corners);
  mesh->endModel();
  return mesh;
}

class FclMethod final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    to_fcl(rest, 1.0f, positions_);
    bodies_.push_back(build_mesh<float>(triangles, positions_));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    constexpr bool kRefit = true, kBottomUp = true;
    to_fcl(positions, 1.0f, positions_);
    bodies_[body]->beginReplaceModel();
    bodies_[body]->replaceSubModel(positions_);
    bodies_[body]->endReplaceModel(kRefit, kBottomUp);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    QueryStats work;
    work.cut_short = max_contacts == 0;
    if (work.cut_short) return work;
    fcl::CollisionResultf found;
    traverse(a, b, max_contacts, found);
    for (std::size_t i = 0; i < found.numContacts(); ++i) {
      const fcl::Contactf& contact = found.getContact(i);
      contacts.push_back(
          {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
    work.cut_short = found.numContacts() == max_contacts;
    return work;
  }

 private:
  void traverse(std::uint32_t a, std::uint32_t b, std::uint32_t max_contacts,
                fcl::CollisionResultf& found) {
    fcl::Transform3f identity_a = fcl::Transform3f::Identity(), identity_b = identity_a;
    fcl::detail::MeshCollisionTraversalNode<fcl::AABBf> node;
    initialize(node, *bodies_[a], identity_a, *bodies_[b], identity_b,
               fcl::CollisionRequestf(max_contacts), found);
    fcl::detail::collide(&node);
  }

  std::vector<std::unique_ptr<Mesh<float>>> bodies_;
  Points<float> positions_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_fcl() { return std::make_unique<FclMethod>(); }

std::string fcl_version() { return FCL_VERSION; }

namespace {

/// Continuous collision detection of two meshes, by a binary tree of boxes over the whole step,
/// refitted bottom-up.
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
class FclMoving final : public MovingMeshMethod {
 public:
  explicit FclMoving(double scale) : scale_(scale) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    to_fcl(rest, scale_, positions_);
    bodies_.push_back(build_mesh<double>(triangles, positions_));
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
  std::vector<std::unique_ptr<Mesh<double>>> bodies_;
  Points<double> positions_;
};

}  // namespace

std::unique_ptr<MovingMeshMethod> make_fcl_moving(double scale) {
  return std::make_unique<FclMoving>(scale);
}

}  // namespace pelt::peers
