/// CGAL's box_intersection_d: sorts two sets of boxes and streams them through a segment tree.
/// Nothing is reused from one query to the next.
///
/// The update computes the boxes of all triangles. A query passes only the boxes that overlap the
/// other body's box, because the algorithm visits its whole input and would spend half of the time
/// on boxes that cannot touch. The narrow phase is ours. An exception from the callback ends a
/// query early, as in CGAL's own does_self_intersect.
///
/// CGAL's box_self_intersection_d: sorts the boxes of all triangles and streams them through a
/// segment tree. Nothing is reused from one query to the next. The update computes the boxes.

#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"
#include "evaluation/peers/cgal_box.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <memory>

namespace pelt::peers {

namespace {

struct Body {
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest) : mesh(triangles, rest) {
    take_boxes();
  }

  void take_boxes() {
    boxes.clear();
    whole = CgalBox();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      CgalBox box;
      for (const Vec3& corner : mesh.corners(t)) box.include(corner);
      box.triangle = t;
      whole.include(box);
      boxes.push_back(box);
    }
  }

  PosedBody mesh;
  std::vector<CgalBox> boxes;
  CgalBox whole;
};

/// Copies the boxes that overlap `where`: the algorithm changes the order of its input.
void select(const Body& body, const CgalBox& where, std::uint32_t number,
            std::vector<CgalBox>& out) {
  out.clear();
  if (!body.whole.meets(where)) return;
  for (const CgalBox& box : body.boxes) {
    if (!box.meets(where)) continue;
    out.push_back(box);
    out.back().body = number;
  }
}

struct Enough {};

class CgalBoxesMethod final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<Body>(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body]->mesh.positions = positions;
    bodies_[body]->take_boxes();
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const Body &body_a = *bodies_[a], &body_b = *bodies_[b];
    select(body_a, body_b.whole, 0, boxes_a_);
    select(body_b, body_a.whole, 1, boxes_b_);
    Candidates candidates(body_a.mesh, body_b.mesh, contacts, max_contacts);
    if (candidates.wants_more()) find(candidates);
    return candidates.work();
  }

 private:
  void find(Candidates& candidates) {
    const auto take = [&](const CgalBox& a, const CgalBox& b) {
      candidates.add(a.triangle, b.triangle);
      if (!candidates.wants_more()) throw Enough();
    };
    try {
      CGAL::box_intersection_d(boxes_a_.begin(), boxes_a_.end(), boxes_b_.begin(), boxes_b_.end(),
                               take, kCutoff);
    } catch (const Enough&) {
    }
  }

  /// CGAL compares sets smaller than this pair by pair.
  static constexpr std::ptrdiff_t kCutoff = 10;

  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<CgalBox> boxes_a_, boxes_b_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_cgal_boxes() {
  return std::make_unique<CgalBoxesMethod>();
}

std::string cgal_version() { return CGAL_VERSION_STR; }

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Triangle_3 cgal_triangle(const detail::TriangleCorners& corners) {
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return {point(corners[0]), point(corners[1]), point(corners[2])};
}

/// CGAL's predicate, which does not accept collapsed triangles.
struct ApartByCgal {
  const PosedBody& mesh;

  bool operator()(std::uint32_t s, std::uint32_t t) const {
    const Kernel::Triangle_3 a = cgal_triangle(mesh.corners(s)), b = cgal_triangle(mesh.corners(t));
    return !a.is_degenerate() && !b.is_degenerate() && CGAL::do_intersect(a, b);
  }
};

struct Surface {
  Surface(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : mesh(triangles, rest), neighbours(triangles, rest) {}

  PosedBody mesh;
  Neighbours neighbours;
  std::vector<CgalBox> boxes;
};

struct EnoughOfSelf {};

template <typename Apart>
class SelfCgalBoxesMethod final : public rivals::PosedMeshMethod {
 public:
  explicit SelfCgalBoxesMethod(OfNeighbours of_neighbours) : of_neighbours_(of_neighbours) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<Surface>(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    Surface& surface = *bodies_[body];
    surface.mesh.positions = positions;
    surface.boxes.resize(surface.mesh.triangles.size());
    for (std::uint32_t t = 0; t < surface.boxes.size(); ++t) {
      CgalBox box;
      for (const Vec3& corner : surface.mesh.corners(t)) box.include(corner);
      box.triangle = t;
      surface.boxes[t] = box;
    }
  }

  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    Surface& surface = *bodies_[a];
    SelfCandidates<Apart> candidates(surface.mesh, surface.neighbours, of_neighbours_,
                                     Apart{surface.mesh}, contacts, max_contacts);
    if (!candidates.wants_more()) return candidates.work();
    const auto take = [&](const CgalBox& s, const CgalBox& t) {
      candidates.add(s.triangle, t.triangle);
      if (!candidates.wants_more()) throw EnoughOfSelf();
    };
    try {
      CGAL::box_self_intersection_d(surface.boxes.begin(), surface.boxes.end(), take, kCutoff);
    } catch (const EnoughOfSelf&) {
    }
    return candidates.work();
  }

 private:
  /// CGAL compares sets smaller than this pair by pair.
  static constexpr std::ptrdiff_t kCutoff = 10;

  OfNeighbours of_neighbours_;
  std::vector<std::unique_ptr<Surface>> bodies_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes() {
  return std::make_unique<SelfCgalBoxesMethod<ApartByPelt>>(OfNeighbours::decided);
}

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_apart() {
  return std::make_unique<SelfCgalBoxesMethod<ApartByPelt>>(OfNeighbours::left_out);
}

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_own() {
  return std::make_unique<SelfCgalBoxesMethod<ApartByCgal>>(OfNeighbours::left_out);
}

}  // namespace pelt::peers
