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

#include "evaluation/rivals/box_tree.hpp"
#include "evaluation/rivals/pair_tests.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace pelt::rivals {
namespace {

/// Memory for descents, so that they allocate nothing after the first ones.
using NodePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Descends two trees of boxes simultaneously: four children of two nodes are tested together, down
/// to pairs of leaves, where the boxes of triangles are compared.
///
/// A side provides `node(n)`, `triangle(i)` and `id(i)` of the i-th triangle in the tree's order,
/// and `points()`. The descent calls `open(n)` before it uses the boxes of the node's children.
template <class SideA, class SideB>
class BoxDescent {
 public:
  BoxDescent(SideA& a, SideB& b, NodePairs& stack, PairTests& tests)
      : a_(a), b_(b), stack_(stack), tests_(tests) {}

  /// Returns the number of pairs of boxes compared, without the boxes of triangles.
  std::uint64_t run() {
    make_room();
    test(0, 0);
    while (waiting_ > 0 && !tests_.full()) {
      const auto [a, b] = stack_[--waiting_];
      make_room();
      open(a, b);
    }
    return compared_;
  }

 private:
  void open(std::uint32_t node_a, std::uint32_t node_b) {
    const BoxNode& a = a_.node(node_a);
    const BoxNode& b = b_.node(node_b);
    if (a.count > 0 && b.count > 0) return compare_triangles(a, b);
    if (a.count == 0) a_.open(node_a);
    if (b.count == 0) b_.open(node_b);
    if (a.count > 0) {
      test(node_a, b.first), test(node_a, b.first + 1);
    } else if (b.count > 0) {
      test(a.first, node_b), test(a.first + 1, node_b);
    } else {
      test(a.first, b.first), test(a.first, b.first + 1);
      test(a.first + 1, b.first), test(a.first + 1, b.first + 1);
    }
  }

  /// Pushes a pair if its boxes overlap. Writes the pair in any case, because a processor cannot
  /// predict whether they overlap.
  void test(std::uint32_t node_a, std::uint32_t node_b) {
    ++compared_;
    stack_[waiting_] = {node_a, node_b};
    waiting_ += overlap(a_.node(node_a).box(), b_.node(node_b).box());
  }

  void make_room() {
    constexpr std::size_t kChildPairs = 4;
    if (stack_.size() < waiting_ + kChildPairs) stack_.resize(2 * (waiting_ + kChildPairs));
  }

  void compare_triangles(const BoxNode& leaf_a, const BoxNode& leaf_b) {
    LeafBoxes boxes_a, boxes_b;
    boxes_a.take(a_, leaf_a, leaf_b.box());
    boxes_b.take(b_, leaf_b, leaf_a.box());
    for (std::uint32_t i = 0; i < boxes_a.count; ++i)
      for (std::uint32_t j = 0; j < boxes_b.count; ++j)
        if (overlap(boxes_a.box[i], boxes_b.box[j])) tests_.add(boxes_a.id[i], boxes_b.id[j]);
  }

  /// The triangles of a leaf whose boxes overlap the other leaf's box.
  struct LeafBoxes {
    Box4 box[kMaxLeafTriangles];
    std::uint32_t id[kMaxLeafTriangles];
    std::uint32_t count = 0;

    template <class Side>
    void take(const Side& side, const BoxNode& leaf, const Box4& other) {
      for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t) {
        box[count] = side.points().box_of(side.triangle(t));
        id[count] = side.id(t);
        count += overlap(box[count], other);
      }
    }
  };

  SideA& a_;
  SideB& b_;
  NodePairs& stack_;
  std::size_t waiting_ = 0;  // pairs on the stack
  PairTests& tests_;
  std::uint64_t compared_ = 0;
};

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

namespace {

// Larsson & Akenine-Moller 2001, "Collision detection for continuously deforming bodies": a tree
// of boxes. Every update refits the upper half of the levels bottom-up. Each box below is computed
// from the vertices below it when a query opens its parent, at most once per update.
//
// Strengthened like AabbRefit. In addition, the boxes at the cut, which cost most, are computed
// from lists of distinct vertices.

/// A tree and the level at which it is cut in two. Levels are contiguous in the tree: the upper
/// nodes are [0, cut), the nodes at the cut [cut, below).
struct HybridShape {
  HybridShape(std::span<const Triangle> triangles, std::span<const Vec3> rest,
              std::uint32_t leaf_triangles)
      : shape(triangles, rest, leaf_triangles) {
    const std::vector<std::uint32_t> level_begin = levels();
    const std::size_t middle = level_begin.size() / 2;
    cut = level_begin[middle];
    below = middle + 1 < level_begin.size() ? level_begin[middle + 1] : node_count();
    for (std::uint32_t n = cut; n < below; ++n) list_vertices(n);
  }

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(shape.tree.nodes.size()); }

  /// The vertices below a node at the cut.
  std::span<const std::uint32_t> vertices_at_cut(std::uint32_t node) const {
    const std::uint32_t begin = cut_begin[node - cut];
    return {cut_vertices.data() + begin, cut_begin[node - cut + 1] - begin};
  }

  TreeShape shape;
  std::uint32_t cut = 0, below = 0;
  std::vector<std::uint32_t> cut_begin = {0};  // by node at the cut, into cut_vertices
  std::vector<std::uint32_t> cut_vertices;

 private:
  /// The first node of each level.
  std::vector<std::uint32_t> levels() const {
    std::vector<std::uint32_t> begin;
    for (std::uint32_t first = 0, end = 1; first < end;) {
      begin.push_back(first);
      std::uint32_t next_end = end;
      for (; first < end; ++first)
        if (const BoxNode& node = shape.tree.nodes[first]; node.count == 0)
          next_end = node.first + 2;
      end = next_end;
    }
    return begin;
  }

  void list_vertices(std::uint32_t node) {
    const auto listed = shape.vertices_below(node);
    std::vector<std::uint32_t> vertices(listed.begin(), listed.end());
    make_vertex_list(vertices);
    cut_vertices.insert(cut_vertices.end(), vertices.begin(), vertices.end());
    cut_begin.push_back(static_cast<std::uint32_t>(cut_vertices.size()));
  }
};

class HybridBody {
 public:
  HybridBody(std::span<const Triangle> triangles, const HybridShape& shape)
      : shape_(shape),
        nodes_(shape.shape.tree.nodes),
        stamps_(nodes_.size(), 0),
        triangles_(triangles) {}

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    if (++stamp_ == 0) {
      std::fill(stamps_.begin(), stamps_.end(), 0);
      stamp_ = 1;
    }
    for (std::uint32_t n = shape_.below; n-- > 0;) refit_upper(n);
  }

  std::uint64_t refits() const { return refits_; }

  // One side of a descent.
  void open(std::uint32_t n) {
    for (std::uint32_t child = nodes_[n].first; child < nodes_[n].first + 2; ++child)
      if (stamps_[child] != stamp_) set(child, box_of(shape_.shape.vertices_below(child), points_));
  }
  const BoxNode& node(std::uint32_t n) const { return nodes_[n]; }
  const Triangle& triangle(std::uint32_t i) const { return triangles_[id(i)]; }
  std::uint32_t id(std::uint32_t i) const { return shape_.shape.tree.order[i]; }
  const Points& points() const { return points_; }
  PosedMesh mesh() const { return {triangles_.data(), points_.data()}; }

 private:
  void refit_upper(std::uint32_t n) {
    const BoxNode& node = nodes_[n];
    if (n >= shape_.cut)
      set(n, box_of(shape_.vertices_at_cut(n), points_));
    else if (node.count > 0)
      set(n, box_of(shape_.shape.vertices_below(n), points_));
    else
      set(n, unite(nodes_[node.first].box(), nodes_[node.first + 1].box()));
  }

  void set(std::uint32_t n, const Box4& box) {
    nodes_[n].set_box(box);
    stamps_[n] = stamp_;
    ++refits_;
  }

  const HybridShape& shape_;
  std::vector<BoxNode> nodes_;
  std::vector<std::uint32_t> stamps_;  // by node: the update that its box is of
  std::uint32_t stamp_ = 0;
  std::span<const Triangle> triangles_;
  Points points_;
  std::uint64_t refits_ = 0;
};

class Hybrid final : public PosedMeshMethod {
 public:
  explicit Hybrid(const TreeOptions& options) : shapes_(options.leaf_triangles) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.emplace_back(triangles, shapes_.of(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body].update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    HybridBody &body_a = bodies_[a], &body_b = bodies_[b];
    const std::uint64_t refits = body_a.refits() + body_b.refits();
    PairTests tests(body_a.mesh(), body_b.mesh(), contacts, max_contacts);
    const std::uint64_t compared = BoxDescent(body_a, body_b, stack_, tests).run();
    QueryStats work = tests.finish();
    work.node_pairs = compared;
    work.refits = body_a.refits() + body_b.refits() - refits;
    return work;
  }

 private:
  SharedShapes<HybridShape> shapes_;
  std::vector<HybridBody> bodies_;
  NodePairs stack_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hybrid(const TreeOptions& options) {
  return std::make_unique<Hybrid>(options);
}

}  // namespace pelt::rivals
