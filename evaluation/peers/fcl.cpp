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
#include <fcl/narrowphase/detail/traversal/collision_node.h>

namespace pelt::peers {
namespace {

using Mesh = fcl::BVHModel<fcl::AABBf>;

void to_fcl(std::span<const Vec3> positions, std::vector<fcl::Vector3f>& out) {
  out.clear();
  for (const Vec3& p : positions) out.emplace_back(p.x, p.y, p.z);
}

class FclMethod final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    std::vector<fcl::Triangle> corners;
    for (const Triangle& t : triangles) corners.emplace_back(t[0], t[1], t[2]);
    to_fcl(rest, positions_);
    auto mesh = std::make_unique<Mesh>();
    mesh->beginModel();
    mesh->addSubModel(positions_, corners);
    mesh->endModel();
    bodies_.push_back(std::move(mesh));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    constexpr bool kRefit = true, kBottomUp = true;
    to_fcl(positions, positions_);
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

  std::vector<std::unique_ptr<Mesh>> bodies_;
  std::vector<fcl::Vector3f> positions_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_fcl() { return std::make_unique<FclMethod>(); }

std::string fcl_version() { return FCL_VERSION; }

}  // namespace pelt::peers
