/// If no triangle of the other surface touches the box of a node, its winding number is constant in
/// the box, and one ray decides it. Nodes in boxes with winding number 0 are skipped.

#include <pelt/solid.hpp>

#include "model/triangle_places.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "ray/ray_descent.hpp"
#include "volume/flux.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace pelt::detail {
namespace {

/// Winding numbers of another surface around the vertices of one node. If the winding number around
/// one vertex is known, it is known around all vertices that triangles of the node connect with it.
class NodeWindings {
 public:
  /// `turns`: ascending by place, for all triangles of the tree. Several turns of one triangle
  /// add up.
  NodeWindings(const Tree& tree, const Node& node, std::span<const WindingTurns> turns);

  /// Whether the winding number around corner 0 of a triangle is known.
  bool is_known(std::uint32_t place) const { return at(place) != kUnknown; }

  /// The winding number around corner 0 of a triangle.
  std::int32_t at(std::uint32_t place) const { return windings_[vertex(place, 0)]; }

  /// Sets the winding number around corner 0 of a triangle, and all that follow from it.
  void set(std::uint32_t place, std::int32_t winding);

 private:
  static constexpr std::int32_t kUnknown = INT32_MIN;
  static constexpr std::size_t kMaxTriangles = std::size_t{kMaxSlots} * kMaxClusterTriangles;

  std::size_t vertex(std::uint32_t place, std::size_t corner) const {
    return tree_.corners[place][corner] / kFloatsPerVertex;
  }

  bool spread(std::uint32_t place);

  const Tree& tree_;
  const Places places_;
  std::array<std::array<std::int32_t, 3>, kMaxTriangles> turns_;  // from corner 0 to each corner
  std::array<std::int32_t, 3 * kMaxTriangles> windings_;          // by vertex of the pool
};

NodeWindings::NodeWindings(const Tree& tree, const Node& node, std::span<const WindingTurns> turns)
    : tree_(tree), places_(places_of(tree, node)) {
  std::fill_n(windings_.begin(), node.vertex_count, kUnknown);
  std::fill_n(turns_.begin(), places_.end - places_.first, std::array<std::int32_t, 3>());
  const auto is_before = [](const WindingTurns& t, std::uint32_t place) { return t.place < place; };
  for (auto turn = std::lower_bound(turns.begin(), turns.end(), places_.first, is_before);
       turn != turns.end() && turn->place < places_.end; ++turn) {
    std::array<std::int32_t, 3>& sum = turns_[turn->place - places_.first];
    sum[1] += turn->to[0];
    sum[2] += turn->to[1];
  }
}

void NodeWindings::set(std::uint32_t place, std::int32_t winding) {
  windings_[vertex(place, 0)] = winding;
  bool has_spread = true;
  while (has_spread) {
    has_spread = false;
    for (std::uint32_t i = places_.first; i < places_.end; ++i) has_spread |= spread(i);
    for (std::uint32_t i = places_.end; i-- > places_.first;) has_spread |= spread(i);
  }
}

/// Returns whether more is known than before.
bool NodeWindings::spread(std::uint32_t place) {
  const std::array<std::int32_t, 3>& turns = turns_[place - places_.first];
  const std::array corners = {vertex(place, 0), vertex(place, 1), vertex(place, 2)};
  const auto is_known_at = [&](std::size_t corner) {
    return windings_[corners[corner]] != kUnknown;
  };
  const std::array known = {is_known_at(0), is_known_at(1), is_known_at(2)};
  if (known[0] == known[1] && known[1] == known[2]) return false;
  const std::size_t from = known[0] ? 0 : known[1] ? 1 : 2;
  const std::int32_t base = windings_[corners[from]] - turns[from];
  for (std::size_t k = 0; k < 3; ++k) windings_[corners[k]] = base + turns[k];
  return true;
}

/// One end of the segment in which two triangles cross.
class End {
 public:
  End(const Piercing& piercing, const TriangleCorners& a, const TriangleCorners& b)
      : piercing_(piercing),
        own_(piercing.is_edge_of_a ? a : b),
        share_(share_of_edge(piercing, a, b)) {}

  RoundedVector position(const Vec3& origin) const {
    return divided(own_[piercing_.edge], own_[(piercing_.edge + 1) % 3], share_, origin);
  }

  /// The flux of the triangle whose edge jumps here.
  Rounded flux(const Vec3& origin) const {
    if (piercing_.edge == 2) return Rounded(0);
    const Rounded jump(piercing_.inwards), whole = jump * flux_of(own_, origin);
    return piercing_.edge == 0 ? whole : whole * (Rounded(1) - share_);
  }

  void add_to(WindingTurns& turns) const {
    if (piercing_.edge == 0) turns.to[0] += piercing_.inwards;
    if (piercing_.edge != 2) turns.to[1] += piercing_.inwards;
  }

 private:
  const Piercing& piercing_;
  const TriangleCorners& own_;
  Rounded share_;
};

}  // namespace

CrossingFlux flux_of(const GenericCrossing& crossing, const TriangleCorners& a,
                     const TriangleCorners& b, const Vec3& origin) {
  const End begin(crossing[0], a, b), end(crossing[1], a, b);
  CrossingFlux result;
  const RoundedVector between = RoundedVector(a[0]) - RoundedVector(b[0]);
  result.flux = dot(between, cross(begin.position(origin), end.position(origin))) +
                begin.flux(origin) + end.flux(origin);
  begin.add_to(crossing[0].is_edge_of_a ? result.turns_a : result.turns_b);
  end.add_to(crossing[1].is_edge_of_a ? result.turns_a : result.turns_b);
  return result;
}

namespace {

Box box_of(const OpenedNode& opened, std::uint32_t slot) {
  return {{opened.low[0][slot], opened.low[1][slot], opened.low[2][slot]},
          {opened.high[0][slot], opened.high[1][slot], opened.high[2][slot]}};
}

class WindingFlux {
 public:
  WindingFlux(const PosedTree& body, const OtherSurface& other, const Vec3& origin,
              pelt::Scratch& scratch, QueryStats& work)
      : body_(body),
        other_(other),
        other_tree_(other.pose.detail().posed_tree()),
        origin_(origin),
        scratch_(scratch),
        work_(work) {}

  Rounded run() {
    visit(0, std::nullopt);
    return flux_;
  }

 private:
  /// `winding`: around all vertices below the node, if it is known.
  void visit(std::uint32_t index, std::optional<int> winding) {
    ++work_.node_pairs;
    const Node& node = body_.tree.nodes[index];
    const OpenedNode& opened = open_node(body_, index, work_);
    winding ? add_triangles(node, opened, *winding) : add_triangles(node, opened);
    for (std::uint32_t child = 0; child < node.child_count; ++child) {
      const auto below = winding ? winding : winding_in(box_of(opened, node.cluster_count + child));
      if (below != 0) visit(node.first_child + child, below);
    }
  }

  void add_triangles(const Node& node, const OpenedNode& opened, int winding) {
    const Places places = places_of(body_.tree, node);
    for (std::uint32_t place = places.first; place < places.end; ++place)
      add(corners_at(body_.tree, place, opened), winding);
  }

  void add_triangles(const Node& node, const OpenedNode& opened) {
    NodeWindings windings(body_.tree, node, other_.turns);
    const Places places = places_of(body_.tree, node);
    for (std::uint32_t place = places.first; place < places.end; ++place) {
      const TriangleCorners corners = corners_at(body_.tree, place, opened);
      if (!windings.is_known(place)) windings.set(place, winding_at(corners[0]));
      if (windings.at(place) != 0) add(corners, windings.at(place));
    }
  }

  void add(const TriangleCorners& corners, int winding) {
    flux_ = flux_ + Rounded(winding) * flux_of(corners, origin_);
  }

  /// Nullopt if the surface touches the box.
  std::optional<int> winding_in(const Box& box) {
    const YesNo touches = intersects(other_.pose, box, scratch_);
    work_ += touches;
    if (touches) return std::nullopt;
    return winding_at(box.low);
  }

  int winding_at(const Vec3& point) {
    int winding = 0;
    if (contains(root_box(other_tree_, work_), point))
      work_ += winding_number(other_tree_, point, other_.motion, winding);
    return winding;
  }

  const PosedTree& body_;
  const OtherSurface& other_;
  const PosedTree other_tree_;
  const Vec3 origin_;
  pelt::Scratch& scratch_;
  QueryStats& work_;
  Rounded flux_{0};
};

}  // namespace

Rounded surface_flux(const PosedTree& posed, const Vec3& origin) {
  Rounded flux(0);
  for (std::uint32_t index = 0; index < posed.tree.nodes.size(); ++index) {
    const Node& node = posed.tree.nodes[index];
    const Places places = places_of(posed.tree, node);
    for (std::uint32_t place = places.first; place < places.end; ++place)
      flux = flux + flux_of(corners_at(posed.tree, place, *posed.opened[index]), origin);
  }
  return flux;
}

Rounded winding_flux(const PosedTree& body, const OtherSurface& other, const Vec3& origin,
                     pelt::Scratch& scratch, QueryStats& work) {
  return WindingFlux(body, other, origin, scratch, work).run();
}

}  // namespace pelt::detail
