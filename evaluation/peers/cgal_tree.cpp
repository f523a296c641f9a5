/// CGAL's AABB tree, built again for each pose, because it cannot be refitted.
///
/// Each triangle of one body that overlaps the other body's box is queried in that body's tree,
/// with CGAL's filtered exact predicates as narrow phase (its tree cannot use ours). A traversal
/// ends when there are enough contacts.
#include "evaluation/peers/adapters.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace pelt::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Corners::const_iterator>;
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<TreeTraits>;

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest) : triangles_(triangles) {
    update(rest);
  }

  void update(std::span<const Vec3> positions) {
    const auto corner = [&](std::uint32_t vertex) {
      const Vec3& p = positions[vertex];
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    corners_.clear();
    for (const Triangle& t : triangles_)
      corners_.emplace_back(corner(t[0]), corner(t[1]), corner(t[2]));
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

class CgalTreeMethod final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<Body>(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body]->update(positions);
  }

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

 private:
  std::vector<std::unique_ptr<Body>> bodies_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_cgal_tree() {
  return std::make_unique<CgalTreeMethod>();
}

}  // namespace pelt::peers
