/// Compiled once for each instruction set.
#include "evaluation/rivals/stages.hpp"

#include "base/instruction_set.hpp"
#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "motion/moving_boxes.hpp"
#include "motion/moving_pairs.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"
#include "self/grid_boxes.hpp"
#include "self/self_descent.hpp"

namespace pelt::rivals {
inline namespace PELT_INSTRUCTION_SET {
namespace {

using detail::Boxes8;
using detail::Float4;
using detail::Float8;
using detail::Mask8;
using detail::MovingBoxes8;
using detail::MovingCluster;
using detail::MovingNode;
using detail::TriangleCorners;

Float4 corner(const PosedMesh& mesh, std::uint32_t triangle, std::size_t k) {
  const Vec3& p = mesh.positions[mesh.triangles[triangle][k]];
  return {p.x, p.y, p.z, 0};
}

TriangleCorners corners(const PosedMesh& mesh, std::uint32_t triangle) {
  const Triangle& v = mesh.triangles[triangle];
  return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

template <typename TriangleAt>
void load(const PosedMesh& mesh, const TriangleAt& triangle, detail::Points8 (&points)[3]) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::uint32_t lane) { return corner(mesh, triangle(lane), k); };
    points[k] = detail::transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  }
}

}  // namespace

Touching touching;

unsigned touching(const PosedMesh& a, const PosedMesh& b, const Contact* pairs,
                  std::uint32_t count) {
  detail::TrianglePairs8 lanes;
  load(
      a, [=](std::uint32_t lane) { return pairs[lane].triangle_a; }, lanes.a);
  load(
      b, [=](std::uint32_t lane) { return pairs[lane].triangle_b; }, lanes.b);
  const detail::Triage verdict = triage(lanes);
  unsigned found = verdict.intersecting;
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    const bool decided = (verdict.intersecting | verdict.apart) >> lane & 1;
    if (!decided && detail::triangles_intersect(corners(a, pairs[lane].triangle_a),
                                                corners(b, pairs[lane].triangle_b)))
      found |= 1u << lane;
  }
  return found & ((1u << count) - 1);
}

namespace {

struct CountPairs {
  static bool is_full() { return false; }
  void test(std::uint32_t, std::uint32_t) { ++count; }

  std::uint64_t count = 0;
};

}  // namespace

DescendSelf descend_self;
BoxAllTriangles box_all_triangles;

std::uint64_t descend_self(const detail::PosedTree& posed, const detail::PairMasks& masks) {
  CountPairs rule;
  QueryStats work;
  detail::SelfDescent(posed, masks, rule, work).run();
  return rule.count;
}

void box_all_triangles(const detail::PosedTree& posed, const detail::PairMasks& masks,
                       detail::Scratch& scratch) {
  const detail::GridBoxes boxes(posed, masks.cluster_nodes.data(), scratch.boxes);
  for (std::uint32_t c = 0; c < posed.tree.clusters.size(); ++c) boxes[c];
}

namespace {

Boxes8 united(const MovingBoxes8& boxes) {
  Boxes8 all;
  for (int axis = 0; axis < 3; ++axis) {
    all.low[axis] = min(boxes.from.low[axis], boxes.to.low[axis]);
    all.high[axis] = max(boxes.from.high[axis], boxes.to.high[axis]);
  }
  return all;
}

/// In place of detail::OverlapUntil.
struct OverlapOfUnions {
  unsigned operator()(const MovingBoxes8& a, const MovingBoxes8& b) const {
    const Boxes8 all_a = united(a), all_b = united(b);
    Mask8 apart = Float8(1.0f) < Float8(0.0f);
    for (int axis = 0; axis < 3; ++axis)
      apart = apart | (all_a.high[axis] < all_b.low[axis]) | (all_b.high[axis] < all_a.low[axis]);
    return ~apart.bits() & 0xFF;
  }
};

/// The query of the library with boxes over the whole step.
class IntersectingUnited : public detail::MovingOverlap {
 public:
  IntersectingUnited(const detail::Tree& a, const detail::Tree& b,
                     const detail::LimitedSink<MovingContact>& sink, const MovingOptions& options,
                     MovingStats& work)
      : sink_(sink), pairs_(a, b), triangles_(pairs_, sink, options, work) {}

  static bool overlaps(const MovingNode& a, const MovingNode& b) {
    return OverlapOfUnions()(box_of(a), box_of(b)) != 0;
  }

  static unsigned slots_near(const MovingNode& of, const MovingNode& all) {
    return OverlapOfUnions()(boxes_of(of), box_of(all));
  }

  static unsigned slots_near(const MovingNode& of, const MovingNode& other, unsigned slot) {
    return OverlapOfUnions()(boxes_of(of), box_of(other, slot));
  }

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }

  void test(const MovingCluster& a, const MovingCluster& b) {
    pairs_.add(a, b, OverlapOfUnions(), [this] { flush(); });
    if (is_impatient()) flush();
  }

  void flush() { triangles_.flush(); }

 private:
  static MovingBoxes8 boxes_of(const MovingNode& node) {
    return {detail::load_boxes(node.from.low, node.from.high, 0),
            detail::load_boxes(node.to.low, node.to.high, 0)};
  }

  const detail::LimitedSink<MovingContact>& sink_;
  detail::WaitingMovingPairs pairs_;
  detail::MovingTrianglePairs<detail::WaitingMovingPairs, const detail::LimitedSink<MovingContact>>
      triangles_;
};

}  // namespace

CollideUnited collide_united;

MovingStats collide_united(const detail::MovingTree& a, const detail::MovingTree& b,
                           detail::Scratch& scratch, const MovingOptions& options) {
  MovingStats work;
  scratch.moving.clear();
  if (!detail::begin_descent(a, b, work)) return work;
  const detail::LimitedSink sink(scratch.moving, options.max_contacts);
  IntersectingUnited rule(a.tree, b.tree, sink, options, work);
  const bool is_unfinished = detail::descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  rule.flush();
  work.cut_short = sink.cut(is_unfinished);
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::rivals
