/// Trees of axis-aligned boxes over posed vertices.
///
/// AabbRefit: van den Bergen 1997, "Efficient collision detection of complex deformable models
/// using AABB trees", section 4: the tree of the rest positions, with its boxes recomputed from the
/// leaves to the root. Collision libraries use this for deforming meshes. AabbRebuild: the same
/// tree, built again, which is tighter and more expensive.
///
/// Strengthened: built by the surface area heuristic, while the source cuts at medians; several
/// triangles per leaf; leaves are refitted from lists of their distinct vertices in memory order;
/// both trees are descended simultaneously.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include "evaluation/rivals/box_descent.hpp"
#include "evaluation/rivals/box_tree.hpp"

namespace pelt::rivals {
namespace {

/// An operand of a descent whose boxes have all been computed before.
class FreshSide {
 public:
  FreshSide(std::span<const BoxNode> nodes, std::span<const std::uint32_t> order,
            std::span<const Triangle> triangles, const Points& points)
      : nodes_(nodes), order_(order), triangles_(triangles), points_(points) {}

  void open(std::uint32_t) const {}
  const BoxNode& node(std::uint32_t n) const { return nodes_[n]; }
  const Triangle& triangle(std::uint32_t i) const { return triangles_[order_[i]]; }
  std::uint32_t id(std::uint32_t i) const { return order_[i]; }
  const Points& points() const { return points_; }
  PosedMesh mesh() const { return {triangles_.data(), points_.data()}; }

 private:
  std::span<const BoxNode> nodes_;
  std::span<const std::uint32_t> order_;
  std::span<const Triangle> triangles_;
  Points points_;
};

/// The shared part of both methods: everything except their bodies.
template <typename Body>
class AabbMethod final : public PosedMeshMethod {
 public:
  explicit AabbMethod(const TreeOptions& options) : shapes_(options.leaf_triangles) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.emplace_back(triangles, rest, shapes_);
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body].update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const FreshSide side_a = bodies_[a].side(), side_b = bodies_[b].side();
    PairTests tests(side_a.mesh(), side_b.mesh(), contacts, max_contacts);
    const std::uint64_t compared = BoxDescent(side_a, side_b, stack_, tests).run();
    QueryStats work = tests.finish();
    work.node_pairs = compared;
    return work;
  }

 private:
  std::vector<Body> bodies_;
  SharedShapes<TreeShape> shapes_;
  NodePairs stack_;
};

class RefitBody {
 public:
  RefitBody(std::span<const Triangle> triangles, std::span<const Vec3> rest,
            SharedShapes<TreeShape>& shapes)
      : shape_(&shapes.of(triangles, rest)), nodes_(shape_->tree.nodes), triangles_(triangles) {}

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    refit_bottom_up(*shape_, points_, nodes_);
  }

  FreshSide side() const { return {nodes_, shape_->tree.order, triangles_, points_}; }

 private:
  const TreeShape* shape_;
  std::vector<BoxNode> nodes_;
  std::span<const Triangle> triangles_;
  Points points_;
};

class RebuiltBody {
 public:
  RebuiltBody(std::span<const Triangle> triangles, std::span<const Vec3>,
              SharedShapes<TreeShape>& shapes)
      : triangles_(triangles), leaf_triangles_(shapes.leaf_triangles()) {}

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    tree_ = build_box_tree(triangles_, points_, leaf_triangles_);
  }

  FreshSide side() const { return {tree_.nodes, tree_.order, triangles_, points_}; }

 private:
  std::span<const Triangle> triangles_;
  std::uint32_t leaf_triangles_;
  Points points_;
  BoxTree tree_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_aabb_refit(const TreeOptions& options) {
  return std::make_unique<AabbMethod<RefitBody>>(options);
}

std::unique_ptr<PosedMeshMethod> make_aabb_rebuild(const TreeOptions& options) {
  return std::make_unique<AabbMethod<RebuiltBody>>(options);
}

}  // namespace pelt::rivals
