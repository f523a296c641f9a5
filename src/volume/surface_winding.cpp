/// A ray from the first vertex v of the triangle along +x decides the winding number w beside v, an
/// infinitesimal step along the ray: that of the triangles that do not have the vertex v. Those
/// with the vertex v form cones around it, so the ray does not meet them again. From there, an arc
/// around v leads to edge 0 of the triangle, from v to u. It meets triangles with the vertex v,
/// each of which changes w by one, and ends in front of the two triangles at the edge, or behind
/// them.

#include "volume/surface_winding.hpp"
#include "query/find_triangle.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pelt::detail {
namespace {

/// Whether a triangle contains a point of the ray from `start` along +x, or may do so: its box
/// does.
bool may_meet(const Vec3& start, const TriangleCorners& t) {
  const auto [y_low, y_high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto [z_low, z_high] = std::minmax({t[0].z, t[1].z, t[2].z});
  return y_low <= start.y && start.y <= y_high && z_low <= start.z && start.z <= z_high &&
         start.x <= std::max({t[0].x, t[1].x, t[2].x});
}

/// The same for the box of a slot.
bool may_meet(const Vec3& start, const OpenedNode& opened, std::uint32_t slot) {
  const auto &low = opened.low, &high = opened.high;
  return low[1][slot] <= start.y && start.y <= high[1][slot] && low[2][slot] <= start.z &&
         start.z <= high[2][slot] && start.x <= high[0][slot];
}

/// Sums up the triangles that may meet the ray.
class RayAndArc {
 public:
  explicit RayAndArc(const NumberedTriangle& start)
      : v_(start[0]), u_(start[1]), last_(start[2]), beyond_(start[2]) {}

  void add(const NumberedTriangle& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i].number == v_.number) return add_around(t[(i + 1) % 3], t[(i + 2) % 3]);
    add_apart(t);
  }

  int winding_in_front() const { return winding_ - (ends_in_front() ? 0 : 1); }

 private:
  /// A triangle that does not have the vertex v: 1 if the ray leaves it, -1 if the ray enters it.
  void add_apart(const NumberedTriangle& t) {
    const int facing = perturbed_facing({v_, t[0], t[1]});
    if (perturbed_facing({v_, t[1], t[2]}) == facing &&
        perturbed_facing({v_, t[2], t[0]}) == facing && perturbed_side(t, v_) == -facing)
      winding_ += facing;
  }

  /// The triangle (v, p, q).
  void add_around(const NumberedPoint& p, const NumberedPoint& q) {
    if (q.number == u_.number) beyond_ = p;
    if (p.number == u_.number || q.number == u_.number) return;
    const int facing = perturbed_facing({v_, p, q}), turn = perturbed_facing({v_, u_, q});
    if (facing == turn && perturbed_facing({v_, u_, p}) == -turn &&
        perturbed_side({v_, p, q}, u_) == -facing)
      winding_ += facing;
  }

  /// Whether the arc ends in front of both triangles at the edge. If the edge is convex, or the
  /// triangles are the front and the back of one, it is enough to be in front of one.
  bool ends_in_front() const {
    const bool is_before = perturbed_facing({v_, u_, last_}) > 0;
    const bool is_before_other = perturbed_facing({v_, beyond_, u_}) > 0;
    const bool is_convex =
        beyond_.number == last_.number || perturbed_side({v_, u_, last_}, beyond_) < 0;
    return is_convex ? is_before || is_before_other : is_before && is_before_other;
  }

  const NumberedPoint v_, u_, last_;
  NumberedPoint beyond_;  // the last vertex of the other triangle at the edge
  int winding_ = 0;
};

/// Adds the triangles whose boxes the ray meets.
class FrontWinding {
 public:
  FrontWinding(const PosedTree& posed, const Surface& surface, const NumberedTriangle& start,
               QueryStats& work)
      : posed_(posed), surface_(surface), start_(start[0].at), sum_(start), work_(work) {}

  int run(Stack<std::uint32_t>& nodes) {
    nodes.clear();
    nodes.push(0);
    while (!nodes.empty()) visit(nodes.pop(), nodes);
    return sum_.winding_in_front();
  }

 private:
  void visit(std::uint32_t index, Stack<std::uint32_t>& nodes) {
    ++work_.node_pairs;
    const Node& node = posed_.tree.nodes[index];
    const OpenedNode& opened = *posed_.opened[index];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      if (may_meet(start_, opened, slot))
        add(posed_.tree.clusters[node.first_cluster + slot], opened);
    for (std::uint32_t child = 0; child < node.child_count; ++child)
      if (may_meet(start_, opened, node.cluster_count + child))
        nodes.push(node.first_child + child);
  }

  void add(const Cluster& cluster, const OpenedNode& opened) {
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
      ++work_.triangle_pairs;
      const std::uint32_t place = cluster.first_triangle + i;
      const TriangleCorners corners = corners_at(posed_.tree, place, opened);
      const Triangle& numbers = surface_.corners[posed_.tree.triangle_ids[place]];
      if (may_meet(start_, corners) && !has_repeated_vertex(numbers))
        sum_.add(numbered(corners, numbers));
    }
  }

  const PosedTree& posed_;
  const Surface& surface_;
  const Vec3 start_;
  RayAndArc sum_;
  QueryStats& work_;
};

}  // namespace

int front_winding(const PosedTree& posed, const Surface& surface, std::uint32_t place,
                  Stack<std::uint32_t>& nodes, QueryStats& work) {
  const std::uint32_t id = posed.tree.triangle_ids[place];
  const NumberedTriangle start =
      numbered(find_triangle(posed, id, work).corners, surface.corners[id]);
  return FrontWinding(posed, surface, start, work).run(nodes);
}

namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

/// An edge of a triangle: three times the place of the triangle, plus the number of the edge.
using Edge = std::uint32_t;

/// An edge by its vertices, the lower one first.
struct NamedEdge {
  std::array<std::uint32_t, 2> vertices;
  Edge edge;

  friend bool operator<(const NamedEdge& a, const NamedEdge& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.edge < b.edge;
  }
};

/// The model owns the surface, which owns the spread: an owner here would make a circle.
SkinnedModel borrowed(const Model& model) {
  return SkinnedModel(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model));
}

std::vector<NamedEdge> sorted_edges(const Surface& surface) {
  const std::vector<std::uint32_t>& ids = surface.model.tree.triangle_ids;
  std::vector<NamedEdge> edges;
  edges.reserve(3 * ids.size());
  for (std::uint32_t place = 0; place < ids.size(); ++place) {
    const Triangle& t = surface.corners[ids[place]];
    if (has_repeated_vertex(t)) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back({{low, high}, 3 * place + i});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Returns for each edge [3 T] the opposite one, or kNone for triangles with repeated vertices.
std::vector<Edge> opposite_edges(const Surface& surface) {
  const std::vector<NamedEdge> edges = sorted_edges(surface);
  std::vector<Edge> opposite(3 * surface.corners.size(), kNone);
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    opposite[edges[i].edge] = edges[i + 1].edge;
    opposite[edges[i + 1].edge] = edges[i].edge;
  }
  return opposite;
}

std::vector<SpreadingStep> spreading_steps(const Surface& surface) {
  const std::vector<Edge> opposite = opposite_edges(surface);
  const std::size_t count = surface.corners.size();
  std::vector<SpreadingStep> steps;
  std::vector<bool> is_reached(count, false);
  const auto reach = [&](const SpreadingStep& step) {
    if (!is_reached[step.triangle]) steps.push_back(step);
    is_reached[step.triangle] = true;
  };
  std::size_t next = 0;
  for (std::uint32_t start = 0; start < count; ++start) {
    if (opposite[std::size_t{3} * start] != kNone) reach({start, start});
    for (; next < steps.size(); ++next)
      for (std::uint8_t i = 0; i < 3; ++i) {
        const Edge other = opposite[std::size_t{3} * steps[next].triangle + i];
        reach({other / 3, steps[next].triangle, static_cast<std::uint8_t>(other % 3), i});
      }
  }
  return steps;
}

}  // namespace

WindingSpread::WindingSpread(const Surface& surface)
    : neighbours(borrowed(surface.model), SelfFilterOptions()), steps(spreading_steps(surface)) {}

const WindingSpread& spread_of(const Surface& surface) {
  return surface.lazy_spread.get([&] { return std::make_shared<const WindingSpread>(surface); });
}

}  // namespace pelt::detail
