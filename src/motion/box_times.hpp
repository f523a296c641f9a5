#pragma once

#include "motion/moving_polynomials.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {
namespace moving {

/// Times outside which the boxes of the triangles are disjoint: multiples of 2^-10.
class BoxTimes {
 public:
  BoxTimes(const MovingTriangle& a, const MovingTriangle& b) {
    cut(a, b, &Vec3::x);
    cut(a, b, &Vec3::y);
    cut(a, b, &Vec3::z);
    if (end_ < start_) return;
    start_ = std::min(std::floor(start_ * 0x1p10), 1023.0) * 0x1p-10;
    end_ = std::max(std::ceil(end_ * 0x1p10) * 0x1p-10, start_ + 0x1p-10);
  }

  bool is_empty() const { return end_ < start_; }
  double start() const { return start_; }
  double end() const { return end_; }

 private:
  struct Range {
    double low, high;

    Range(const TriangleCorners& t, float Vec3::*axis)
        : low(std::min({t[0].*axis, t[1].*axis, t[2].*axis})),
          high(std::max({t[0].*axis, t[1].*axis, t[2].*axis})) {}
  };

  void cut(const MovingTriangle& a, const MovingTriangle& b, float Vec3::*axis) {
    const Range a0(a.from, axis), a1(a.to, axis), b0(b.from, axis), b1(b.to, axis);
    cut(b0.low - a0.high, b1.low - a1.high);
    cut(a0.low - b0.high, a1.low - b1.high);
  }

  /// Leaves out the times at which there is a gap, given at times 0 and 1. The quotient has four
  /// relative errors 2^-53.
  void cut(double gap_at_0, double gap_at_1) {
    if (gap_at_0 > 0 && gap_at_1 > 0) end_ = -1;
    if ((gap_at_0 > 0) == (gap_at_1 > 0)) return;
    const double quotient = gap_at_0 / (gap_at_0 - gap_at_1);
    if (gap_at_0 > 0) start_ = std::max(start_, quotient * (1 - 0x1p-50));
    if (gap_at_1 > 0) end_ = std::min(end_, quotient * (1 + 0x1p-50));
  }

  double start_ = 0, end_ = 1;
};

}  // namespace moving
}  // namespace pelt::detail
