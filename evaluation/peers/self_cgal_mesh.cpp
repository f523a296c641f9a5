/// CGAL's Polygon_mesh_processing::self_intersections on a Surface_mesh, with its filtered exact
/// predicates.
///
/// Its rule for triangles that share a corner or an edge is that of self_collide. But CGAL does not
/// accept collapsed triangles, which are left out, and its meshes are manifold: a triangle that
/// cannot be added gets vertices of its own, and then touches its neighbours. For CGAL, a crack
/// that opens stays closed. The update sets the points of the mesh and finds collapsed triangles.
#include "evaluation/peers/self_adapters.hpp"
#include "evaluation/peers/self_candidates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <boost/iterator/function_output_iterator.hpp>

#include <memory>

namespace pelt::peers {
namespace {

using MeshKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<MeshKernel::Point_3>;

MeshKernel::Point_3 mesh_point(const Vec3& p) { return {p.x, p.y, p.z}; }

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
      cgal_.point(v) = mesh_point(positions[vertices_[v]]);
    mesh_.positions = positions;
    faces_.clear();
    for (const Mesh::Face_index face : cgal_.faces()) {
      const detail::TriangleCorners c = mesh_.corners(face);
      if (!CGAL::collinear(mesh_point(c[0]), mesh_point(c[1]), mesh_point(c[2])))
        faces_.push_back(face);
    }
  }

  const Mesh& cgal() const { return cgal_; }
  const std::vector<Mesh::Face_index>& faces() const { return faces_; }

 private:
  Mesh::Vertex_index add_vertex(std::uint32_t vertex) {
    vertices_.push_back(vertex);
    return cgal_.add_vertex(mesh_point(mesh_.positions[vertex]));
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

struct EnoughOfMesh {};

class SelfCgalMeshMethod final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<MeshBody>(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body]->update(positions);
  }

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
      if (work.cut_short) throw EnoughOfMesh();
    };
    try {
      CGAL::Polygon_mesh_processing::self_intersections(body.faces(), body.cgal(),
                                                        boost::make_function_output_iterator(take));
    } catch (const EnoughOfMesh&) {
    }
    return work;
  }

 private:
  std::vector<std::unique_ptr<MeshBody>> bodies_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_mesh() {
  return std::make_unique<SelfCgalMeshMethod>();
}

}  // namespace pelt::peers
