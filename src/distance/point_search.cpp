#include "distance/point_search.hpp"

#include "distance/triangle_search.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

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
