/// Nearest-first descent of two trees. The larger part of a pair is replaced by its slots, and
/// eight slots are compared with the other part at once. The closest pair is visited first, so a
/// near pair is known early, and nodes beyond it are never opened. A stack of at most eight parts
/// per level suffices.

#include "distance/distance_search.hpp"

#include "distance/near_triangles.hpp"
#include "distance/triangle_search.hpp"
#include "pose/open_node.hpp"
#include "query/nearest_search.hpp"
#include "query/scratch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

// Finds a place near the closest one: the cluster whose box is closest to a point. Tests no
// triangles, and opens only nodes whose boxes are nearer than the best cluster so far.

/// Precondition: there is a table of opened nodes.
inline TreePart closest_cluster(const PosedTree& posed, const Vec3& point, Stack<NearPart>& parts,
                                QueryStats& work) {
  const Box8 box = {{Float8(point.x), Float8(point.y), Float8(point.z)},
                    {Float8(point.x), Float8(point.y), Float8(point.z)}};
  NearPart closest = {HUGE_VALF, 0, TreePart::kWhole};
  parts.clear();
  parts.push({0, 0, TreePart::kWhole});
  while (!parts.empty()) {
    const NearPart near = parts.pop();
    if (!(near.squared_gap < closest.squared_gap)) continue;
    const TreePart part = {near.node, near.slot};
    if (is_cluster(posed, part)) {
      closest = near;
      continue;
    }
    ++work.node_pairs;
    const std::uint32_t node = node_of(posed, part);
    const OpenedNode& opened = open_node(posed, node, work);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, box);
    const unsigned nearer = (gaps < Float8(closest.squared_gap)).bits();
    push_nearest_last(parts, nearer & slots_of(posed.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }
  return {closest.node, closest.slot};
}

/// Returns the point of a cluster's box that is closest to a given point.
inline Vec3 closest_of_box(const PosedTree& posed, const TreePart& cluster, const Vec3& point) {
  const OpenedNode& opened = *posed.opened[cluster.node];
  const auto closest = [&](int axis, float x) {
    const float low = opened.low[axis][cluster.slot], high = opened.high[axis][cluster.slot];
    return x < low ? low : x > high ? high : x;
  };
  return {closest(0, point.x), closest(1, point.y), closest(2, point.z)};
}

/// Collects all pairs within a distance, in addition to the touching ones.
class AllWithin {
 public:
  AllWithin(double distance, std::uint32_t max_pairs, Stack<Contact>& pairs)
      : distance_(distance), max_pairs_(max_pairs), any_touch_(!pairs.empty()), pairs_(pairs) {}

  double reach() const { return distance_; }
  bool keeps_best() const { return false; }
  bool is_done() const { return pairs_.size() >= max_pairs_; }

  bool wants(const TriangleGap& gap) const {
    return std::sqrt(gap.closest.squared_distance) <= distance_;
  }

  void take(const TriangleGap& gap) {
    if (any_touch_ && triangles_intersect(gap.corners_a, gap.corners_b)) return;
    pairs_.push({gap.triangle_a, gap.triangle_b});
  }

 private:
  double distance_;
  std::uint32_t max_pairs_;
  bool any_touch_;  ///< whether any pair touches; touching pairs are known
  Stack<Contact>& pairs_;
};

double extent(const RootBox& a, const RootBox& b) {
  return common_extent(a.low, a.high, b.low, b.high);
}

/// The sum of the box's sides.
float size(const Box8& box) {
  Float8 sum(0.0f);
  for (int axis = 0; axis < 3; ++axis) sum = sum + (box.high[axis] - box.low[axis]);
  return sum.low()[0];
}

template <typename Goal>
class PairSearch {
 public:
  PairSearch(const PosedTree& a, const PosedTree& b, Scratch& scratch, Goal& goal)
      : a_(a),
        b_(b),
        near_point_(scratch.near_part),
        parts_(scratch.near_parts),
        goal_(goal),
        triangles_(goal, extent(root_box(a, work_), root_box(b, work_)), work_) {}

  /// `limit`: units of work after which the search ends.
  QueryStats run(const ClusterSlots* begin = nullptr,
                 std::uint64_t limit = SearchLimits::kUnlimited) {
    parts_.clear();
    parts_.push({0, 0, TreePart::kWhole, 0, TreePart::kWhole});
    if (!is_near()) return work_;
    make_table(a_);
    make_table(b_);
    if (begin) look_first(*begin);
    while (!parts_.empty() && !goal_.is_done() && !is_spent(limit)) {
      const NearParts pair = parts_.pop();
      if (pair.squared_gap <= triangles_.reach().squared_gap())
        visit({pair.node_a, pair.slot_a}, {pair.node_b, pair.slot_b});
    }
    triangles_.flush();
    work_.cut_short = goal_.is_done() || !parts_.empty();
    return work_;
  }

  /// Lower bound of the distances of all pairs that are left.
  double open_distance() const {
    float least = std::numeric_limits<float>::infinity();
    for (const NearParts& pair : parts_) least = std::min(least, pair.squared_gap);
    return triangles_.reach().least_distance(least);
  }

 private:
  bool is_spent(std::uint64_t limit) const {
    return limit != SearchLimits::kUnlimited && work_of(work_) >= limit;
  }

  /// Whether the boxes of the roots are within reach.
  bool is_near() {
    ++work_.node_pairs;
    const RootBox &a = root_box(a_, work_), &b = root_box(b_, work_);
    return is_within_reach(point_box(a.low, a.high), point_box(b.low, b.high));
  }

  /// Finds two clusters that are not much farther apart than the closest ones: the cluster of `b`
  /// that is closest to the middle of `a`, and the cluster of `a` that is closest to that. This
  /// opens a few nodes, most of which are needed anyway, and saves the comparisons that would be
  /// made before anything near is known.
  ClusterSlots guess() {
    const RootBox& box = a_.root_box;
    const auto middle = [&](int axis) { return box.low[axis] / 2 + box.high[axis] / 2; };
    const Vec3 in_a = {middle(0), middle(1), middle(2)};
    const TreePart b = closest_cluster(b_, in_a, near_point_, work_);
    const TreePart a = closest_cluster(a_, closest_of_box(b_, b, in_a), near_point_, work_);
    return {a.node, a.slot, b.node, b.slot};
  }

  void look_first(const ClusterSlots& slots) {
    const TreePart a = {slots[0], slots[1]}, b = {slots[2], slots[3]};
    if (a.node >= a_.tree.nodes.size() || !is_cluster(a_, a)) return;
    if (b.node >= b_.tree.nodes.size() || !is_cluster(b_, b)) return;
    open_node(a_, a.node, work_);
    open_node(b_, b.node, work_);
    compare(a, b);
    first_a_ = a, first_b_ = b;
    has_begun_ = true;
  }

  /// Whether these clusters have already been compared.
  bool were_first(const TreePart& a, const TreePart& b) const {
    return a.node == first_a_.node && a.slot == first_a_.slot && b.node == first_b_.node &&
           b.slot == first_b_.slot;
  }

  void visit(const TreePart& a, const TreePart& b) {
    const bool a_is_cluster = is_cluster(a_, a), b_is_cluster = is_cluster(b_, b);
    if (a_is_cluster && b_is_cluster) return arrive(a, b);
    const Box8 box_a = known_box(a_, a), box_b = known_box(b_, b);
    if (!is_within_reach(box_a, box_b)) return;
    if (b_is_cluster || (!a_is_cluster && goes_first(a, box_a, b, box_b))) {
      replace(a_, a, box_b, [&](std::uint32_t node, unsigned slot, float gap) {
        return NearParts{gap, node, slot, b.node, b.slot};
      });
    } else {
      replace(b_, b, box_a, [&](std::uint32_t node, unsigned slot, float gap) {
        return NearParts{gap, a.node, a.slot, node, slot};
      });
    }
  }

  /// Whether to replace a part of the first tree before one of the second: if the part is open,
  /// because the other may then never be opened; otherwise if it is larger.
  bool goes_first(const TreePart& a, const Box8& box_a, const TreePart& b,
                  const Box8& box_b) const {
    const bool a_is_open = a_.opened[node_of(a_, a)], b_is_open = b_.opened[node_of(b_, b)];
    return a_is_open != b_is_open ? a_is_open : size(box_a) >= size(box_b);
  }

  bool is_within_reach(const Box8& a, const Box8& b) const {
    const Float8 most(triangles_.reach().squared_gap());
    return ((squared_gap(a, b) <= most).bits() & 1) != 0;
  }

  /// Compares two clusters. Before the first comparison, compares clusters that may be nearer.
  void arrive(const TreePart& a, const TreePart& b) {
    if (!has_begun_ && goal_.keeps_best()) look_first(guess());
    if (!were_first(a, b)) compare(a, b);
  }

  void compare(const TreePart& a, const TreePart& b) {
    triangles_.add(cluster_of(a_, a), cluster_of(b_, b), {a.node, a.slot, b.node, b.slot});
  }

  /// Pushes the pairs of a part's slots with the other part, whose box is `other`.
  template <typename Pair>
  void replace(const PosedTree& posed, const TreePart& part, const Box8& other, const Pair& pair) {
    ++work_.node_pairs;
    const std::uint32_t node = node_of(posed, part);
    const OpenedNode& opened = open_node(posed, node, work_);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, other);
    const unsigned near = (gaps <= Float8(triangles_.reach().squared_gap())).bits();
    push_nearest_last(parts_, near & slots_of(posed.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) { return pair(node, slot, gap); });
  }

  const PosedTree &a_, &b_;
  Stack<NearPart>& near_point_;
  Stack<NearParts>& parts_;  // the top is visited next
  Goal& goal_;
  bool has_begun_ = false;
  TreePart first_a_, first_b_;  // the first compared clusters; whole trees before that
  QueryStats work_;
  NearTriangles<Goal> triangles_;
};

}  // namespace

QueryStats closest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& closest) {
  LeastGap goal(limits, closest);
  PairSearch search(a, b, scratch, goal);
  const QueryStats work = search.run(limits.begin, limits.work);
  closest.open_distance = search.open_distance();
  return work;
}

QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs) {
  AllWithin goal(tolerance, max_pairs, scratch.found);
  return PairSearch(a, b, scratch, goal).run();
}

namespace {

// The search from a point.

/// Finds the triangle closest to a point; among equally near ones the lowest.
class ClosestToPoint {
 public:
  ClosestToPoint(const Vec3& point, double max_distance, PointGap& best)
      : point_(point),
        box_{{Float8(point.x), Float8(point.y), Float8(point.z)},
             {Float8(point.x), Float8(point.y), Float8(point.z)}},
        reach_(max_distance),
        best_(best) {}

  double extent(const RootBox& box) const {
    const float point[3] = {point_.x, point_.y, point_.z};
    return common_extent(box.low, box.high, point, point);
  }

  Float8 squared_gaps(const Boxes8& boxes) const { return squared_gap(boxes, box_); }

  bool takes(std::uint32_t triangle, const TriangleCorners& corners) {
    const ClosestOnTriangle closest = closest_on_triangle(Vec3d(point_), corners);
    if (!is_better(closest.squared_distance, triangle)) return false;
    best_ = {triangle, corners, closest};
    reach_ = std::sqrt(closest.squared_distance);
    return true;
  }

  double reach() const { return reach_; }

 private:
  bool is_better(double squared, std::uint32_t triangle) const {
    const double best = best_.closest.squared_distance;
    if (squared == best) return triangle < best_.triangle;
    return squared < best && std::sqrt(squared) <= reach_;
  }

  const Vec3 point_;
  const Box8 box_;  // around the point
  double reach_;    // the maximum; later the least distance so far
  PointGap& best_;
};

}  // namespace

QueryStats closest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& closest) {
  ClosestToPoint goal(point, max_distance, closest);
  return TriangleSearch(posed, scratch, goal).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
