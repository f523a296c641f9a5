/// Larsson & Akenine-Moller 2001, "Collision detection for continuously deforming bodies": a tree
/// of boxes. Every update refits the upper half of the levels bottom-up. Each box below is computed
/// from the vertices below it when a query opens its parent, at most once per update.
///
/// Strengthened like aabb.hpp. In addition, the boxes at the cut, which cost most, are computed
/// from lists of distinct vertices.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include "evaluation/rivals/box_descent.hpp"
#include "evaluation/rivals/box_tree.hpp"

#include <algorithm>

namespace pelt::rivals {
namespace {

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
