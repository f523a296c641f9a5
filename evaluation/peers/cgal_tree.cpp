/// CGAL's AABB tree, built again for each pose, because it cannot be refitted.
///
/// Each triangle of one body that overlaps the other body's box is queried in that body's tree,
/// with CGAL's filtered exact predicates as narrow phase (its tree cannot use ours). A traversal
/// ends when there are enough contacts.

#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <boost/iterator/function_output_iterator.hpp>

#include <memory>

namespace pelt::peers {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Corners::const_iterator>;
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<TreeTraits>;

Kernel::Point_3 point(const Vec3& p) { return {p.x, p.y, p.z}; }

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest) : triangles_(triangles) {
    update(rest);
  }

  void update(std::span<const Vec3> positions) {
    corners_.clear();
    for (const auto& [a, b, c] : triangles_)
      corners_.emplace_back(point(positions[a]), point(positions[b]), point(positions[c]));
    tree_.rebuild(corners_.cbegin(), corners_.cend());
  }

  const Corners& corners() const { return corners_; }
  const Tree& tree() const { return tree_; }

  std::uint32_t number_of(const Primitive& primitive) const {
    return static_cast<std::uint32_t>(primitive.id() - corners_.cbegin());
  }

 private:
  std::span<const Triangle> triangles_;
  Corners corners_;
  Tree tree_;
};

/// Callbacks for CGAL's trees: collects the triangles of one body that intersect a triangle of the
/// other.
class Search {
 public:
  Search(const Body& body, std::vector<Contact>& contacts, std::uint32_t max_contacts)
      : body_(body), contacts_(contacts), wanted_(max_contacts) {
    work_.cut_short = wanted_ == 0;
  }

  void ask(const Kernel::Triangle_3& triangle, std::uint32_t its_number) {
    other_ = its_number;
    body_.tree().traversal(triangle, *this);
  }

  bool go_further() const { return wanted_ > 0; }

  void intersection(const Kernel::Triangle_3& triangle, const Primitive& primitive) {
    ++work_.triangle_pairs;
    if (!traits_.do_intersect_object()(triangle, primitive)) return;
    contacts_.push_back({body_.number_of(primitive), other_});
    work_.cut_short = --wanted_ == 0;
  }

  bool do_intersect(const Kernel::Triangle_3& triangle, const CGAL::AABB_node<TreeTraits>& node) {
    ++work_.node_pairs;
    return traits_.do_intersect_object()(triangle, node.bbox());
  }

  const QueryStats& work() const { return work_; }

 private:
  const Body& body_;
  std::vector<Contact>& contacts_;
  std::uint32_t wanted_, other_ = 0;
  TreeTraits traits_;
  QueryStats work_;
};

class CgalTreeMethod final : public MethodOfBodies<Body> {
 public:
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const CGAL::Bbox_3 box_a = bodies_[a]->tree().bbox(), box_b = bodies_[b]->tree().bbox();
    Search search(*bodies_[a], contacts, max_contacts);
    if (!CGAL::do_overlap(box_a, box_b)) return search.work();
    const Corners& corners = bodies_[b]->corners();
    for (std::uint32_t t = 0; t < corners.size() && search.go_further(); ++t)
      if (CGAL::do_overlap(corners[t].bbox(), box_a)) search.ask(corners[t], t);
    return search.work();
  }
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_cgal_tree() {
  return std::make_unique<CgalTreeMethod>();
}

namespace {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

class MeshBody {
 public:
  MeshBody(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : mesh_(triangles, rest) {
    const std::vector<std::uint32_t> surface = surface_vertices(rest);
    std::map<std::uint32_t, Mesh::Vertex_index> known;
    for (const Triangle& t : triangles) add_triangle(t, surface, known);
    update(rest);
  }

  void update(std::span<const Vec3> positions) {
    for (const Mesh::Vertex_index v : cgal_.vertices())
      cgal_.point(v) = point(positions[vertices_[v]]);
    mesh_.positions = positions;
    faces_.clear();
    for (const Mesh::Face_index face : cgal_.faces()) {
      const detail::TriangleCorners c = mesh_.corners(face);
      if (!CGAL::collinear(point(c[0]), point(c[1]), point(c[2]))) faces_.push_back(face);
    }
  }

  const Mesh& cgal() const { return cgal_; }
  const std::vector<Mesh::Face_index>& faces() const { return faces_; }

 private:
  Mesh::Vertex_index add_vertex(std::uint32_t vertex) {
    vertices_.push_back(vertex);
    return cgal_.add_vertex(point(mesh_.positions[vertex]));
  }

  void add_triangle(const Triangle& t, const std::vector<std::uint32_t>& surface,
                    std::map<std::uint32_t, Mesh::Vertex_index>& known) {
    std::array<Mesh::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [vertex, is_new] = known.try_emplace(surface[t[k]]);
      if (is_new) vertex->second = add_vertex(surface[t[k]]);
      corners[k] = vertex->second;
    }
    const bool is_triangle =
        corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
    if (is_triangle && cgal_.add_face(corners[0], corners[1], corners[2]) != Mesh::null_face())
      return;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = add_vertex(t[k]);
    cgal_.add_face(corners[0], corners[1], corners[2]);
  }

  PosedBody mesh_;
  Mesh cgal_;
  std::vector<std::uint32_t> vertices_;  // of the caller, by vertex of `cgal_`
  std::vector<Mesh::Face_index> faces_;
};

struct Enough {};

/// CGAL's Polygon_mesh_processing::self_intersections on a Surface_mesh, with its filtered exact
/// predicates.
///
/// Its rule for triangles that share a corner or an edge is that of self_collide. But CGAL does not
/// accept collapsed triangles, which are left out, and its meshes are manifold: a triangle that
/// cannot be added gets vertices of its own, and then touches its neighbours. For CGAL, a crack
/// that opens stays closed. The update sets the points of the mesh and finds collapsed triangles.
class SelfCgalMeshMethod final : public MethodOfBodies<MeshBody> {
 public:
  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    QueryStats work;
    work.cut_short = max_contacts == 0;
    if (work.cut_short) return work;
    const MeshBody& body = *bodies_[a];
    const auto take = [&](const std::pair<Mesh::Face_index, Mesh::Face_index>& pair) {
      const std::uint32_t s = pair.first, t = pair.second;
      contacts.push_back({std::min(s, t), std::max(s, t)});
      work.cut_short = --max_contacts == 0;
      if (work.cut_short) throw Enough();
    };
    try {
      CGAL::Polygon_mesh_processing::self_intersections(body.faces(), body.cgal(),
                                                        boost::make_function_output_iterator(take));
    } catch (const Enough&) {
    }
    return work;
  }
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_mesh() {
  return std::make_unique<SelfCgalMeshMethod>();
}

}  // namespace pelt::peers
