/// Most pairs with equal first times have the same meeting corners: for example, a vertex that
/// several triangles share reaches a face. Both times are then roots of one determinant. If its
/// derivative has one certain sign around the float of both times, it has only one root there, and
/// the times are equal.
///
/// Rounding, with u = 2^-53. Let V be the product of the largest components of the three vectors at
/// both ends. A component near the time has an error below 4 u, relative to its largest value, and
/// is at most 1 + 2^-11 times this value. A product of three has an error below 16 u V, a
/// determinant of six below 128 u V, a coefficient below 160 u V, and a difference of two
/// coefficients below 512 u V. The bound is 2^-40 V.
#include "motion/meeting_order.hpp"

#include "base/vec3.hpp"
#include "exact/critical_time.hpp"
#include "motion/moving_determinants.hpp"
#include "motion/moving_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt::detail {
namespace {

/// A corner at both ends of the step.
struct MovingCorner {
  Vec3 from, to;

  friend bool operator==(const MovingCorner& p, const MovingCorner& q) {
    return p.from == q.from && p.to == q.to;
  }
};

/// The corners of two features that meet: a corner and a face, or two edges. Empty for others.
class MeetingCorners {
 public:
  explicit MeetingCorners(const MeetingPair& pair) {
    add(pair.a, pair.first.a);
    add(pair.b, pair.first.b);
  }

  bool are_four() const { return count_ == 4; }

  const MovingCorner& operator[](std::size_t i) const { return corners_[i]; }

  bool is_permutation_of(const MeetingCorners& other) const {
    return std::is_permutation(corners_.begin(), corners_.begin() + 4, other.corners_.begin());
  }

 private:
  void add(const MovingTriangle& triangle, const Feature& feature) {
    const std::size_t corners = feature.kind == FeatureKind::corner ? 1
                                : feature.kind == FeatureKind::edge ? 2
                                                                    : 3;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t corner = (feature.number + i) % 3;
      corners_[count_++] = {triangle.from[corner], triangle.to[corner]};
    }
  }

  std::array<MovingCorner, 6> corners_;
  std::size_t count_ = 0;
};

using Differences = std::array<Vec3d, 3>;

Differences differences(const MeetingCorners& corners, Vec3 MovingCorner::*end) {
  const Vec3d origin(corners[0].*end);
  return {Vec3d(corners[1].*end) - origin, Vec3d(corners[2].*end) - origin,
          Vec3d(corners[3].*end) - origin};
}

double largest(const Vec3d& p, const Vec3d& q) {
  return std::max(
      {std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
}

/// Whether the determinant of four corners certainly has at most one root near a time.
bool is_monotonic_near(const MeetingCorners& corners, double time) {
  constexpr double kNear = 0x1p-12;
  const Differences at_0 = differences(corners, &MovingCorner::from);
  const Differences at_1 = differences(corners, &MovingCorner::to);
  Differences from, to;
  double error = 0x1p-40;
  for (std::size_t i = 0; i < 3; ++i) {
    from[i] = between(time - kNear, at_0[i], at_1[i]);
    to[i] = between(time + kNear, at_0[i], at_1[i]);
    error *= largest(at_0[i], at_1[i]);
  }
  BernsteinCubic<double> cubic;
  MovingCross<Vec3d, double>(from[0], to[0], from[1], to[1]).times(from[2], to[2], 1.0 / 3, cubic);
  const double slopes[3] = {cubic[1] - cubic[0], cubic[2] - cubic[1], cubic[3] - cubic[2]};
  return std::all_of(slopes, slopes + 3, [&](double s) { return s > error; }) ||
         std::all_of(slopes, slopes + 3, [&](double s) { return s < -error; });
}

/// Whether both times are certainly the same root. Precondition: their floats are equal.
bool have_same_root(const MeetingPair& p, const MeetingPair& q) {
  const MeetingCorners of_p(p), of_q(q);
  return of_p.are_four() && of_q.are_four() && of_p.is_permutation_of(of_q) &&
         is_monotonic_near(of_p, double{p.first.time});
}

}  // namespace

std::optional<int> certain_order(const MeetingPair& p, const MeetingPair& q) {
  const float time_p = p.first.time, time_q = q.first.time;
  if (time_p != time_q) return time_p < time_q ? -1 : 1;
  if (time_p == 1 || have_same_root(p, q)) return 0;
  return std::nullopt;
}

int compare_first_times(const MeetingPair& p, const MeetingPair& q) {
  if (const std::optional<int> order = certain_order(p, q)) return *order;
  return first_time_of(p.a, p.b).compare(first_time_of(q.a, q.b));
}

void EarliestPair::add(const Contact& contact, const MovingTriangle& a, const MovingTriangle& b,
                       MovingStats& work) {
  const std::optional<FirstMeeting> first = find_first_meeting(a, b, work);
  if (first && !first->at_start) add(contact, {a, b, *first});
}

bool EarliestPair::add(const Contact& contact, const MeetingPair& pair) {
  std::optional<int> order = pair_ ? certain_order(pair, *pair_) : -1;
  const bool is_certain = order.has_value();
  if (!is_certain) order = compare_first_times(pair, *pair_);
  if (*order < 0 || (*order == 0 && contact < contact_)) {
    contact_ = contact;
    pair_ = pair;
  }
  return is_certain;
}

float EarliestPair::latest() const { return pair_ ? std::nextafter(pair_->first.time, 2.0f) : 1; }

std::optional<MovingContact> EarliestPair::contact() const {
  if (!pair_) return std::nullopt;
  return moving_contact(contact_, pair_->first);
}

}  // namespace pelt::detail
