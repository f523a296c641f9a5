/// If no triangle of the other surface touches the box of a node, its winding number is constant in
/// the box, and one ray decides it. Nodes in boxes with winding number 0 are skipped.

#include "volume/winding_flux.hpp"

#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "ray/ray_descent.hpp"
#include "volume/flux.hpp"
#include "volume/node_windings.hpp"

#include <pelt/solid.hpp>

#include <optional>

namespace pelt::detail {
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
