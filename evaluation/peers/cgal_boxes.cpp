/// CGAL's box_intersection_d: sorts two sets of boxes and streams them through a segment tree.
/// Nothing is reused from one query to the next.
///
/// The update computes the boxes of all triangles. A query passes only the boxes that overlap the
/// other body's box, because the algorithm visits its whole input and would spend half of the time
/// on boxes that cannot touch. The narrow phase is ours. An exception from the callback ends a
/// query early, as in CGAL's own does_self_intersect.

#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

namespace pelt::peers {

namespace {

/// A model of CGAL's concept BoxIntersectionBox_d.
struct CgalBox {
  using NT = float;
  using ID = std::uint32_t;

  static int dimension() { return 3; }
  float min_coord(int axis) const { return low[axis]; }
  float max_coord(int axis) const { return high[axis]; }
  /// Distinct in both sets together.
  ID id() const { return triangle | body << 31; }

  void include(const Vec3& p) {
    const float at[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
  }
  void include(const CgalBox& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  bool meets(const CgalBox& other) const {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
      all = all && low[axis] <= other.high[axis] && other.low[axis] <= high[axis];
    return all;
  }

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  float low[3] = {kInfinity, kInfinity, kInfinity};
  float high[3] = {-kInfinity, -kInfinity, -kInfinity};
  std::uint32_t triangle = 0;
  std::uint32_t body = 0;  ///< 0 or 1, within a query
};

CgalBox box_of(const PosedBody& mesh, std::uint32_t triangle) {
  CgalBox box;
  for (const Vec3& corner : mesh.corners(triangle)) box.include(corner);
  box.triangle = triangle;
  return box;
}

struct Body {
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest) : mesh(triangles, rest) {
    take_boxes();
  }

  void update(std::span<const Vec3> positions) {
    mesh.positions = positions;
    take_boxes();
  }

  void take_boxes() {
    boxes.clear();
    whole = CgalBox();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      boxes.push_back(box_of(mesh, t));
      whole.include(boxes.back());
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

/// Thrown to end a query.
struct Enough {};

/// CGAL compares sets smaller than this pair by pair.
constexpr std::ptrdiff_t kCutoff = 10;

class CgalBoxesMethod final : public MethodOfBodies<Body> {
 public:
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

  void update(std::span<const Vec3> positions) {
    mesh.positions = positions;
    boxes.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < boxes.size(); ++t) boxes[t] = box_of(mesh, t);
  }

  PosedBody mesh;
  Neighbours neighbours;
  std::vector<CgalBox> boxes;
};

/// CGAL's box_self_intersection_d: sorts the boxes of all triangles and streams them through a
/// segment tree. Nothing is reused from one query to the next. The update computes the boxes.
template <typename Apart>
class SelfCgalBoxesMethod final : public MethodOfBodies<Surface> {
 public:
  explicit SelfCgalBoxesMethod(OfNeighbours of_neighbours) : of_neighbours_(of_neighbours) {}

  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    Surface& surface = *bodies_[a];
    SelfCandidates<Apart> candidates(surface.mesh, surface.neighbours, of_neighbours_,
                                     Apart{surface.mesh}, contacts, max_contacts);
    if (!candidates.wants_more()) return candidates.work();
    const auto take = [&](const CgalBox& s, const CgalBox& t) {
      candidates.add(s.triangle, t.triangle);
      if (!candidates.wants_more()) throw Enough();
    };
    try {
      CGAL::box_self_intersection_d(surface.boxes.begin(), surface.boxes.end(), take, kCutoff);
    } catch (const Enough&) {
    }
    return candidates.work();
  }

 private:
  OfNeighbours of_neighbours_;
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
