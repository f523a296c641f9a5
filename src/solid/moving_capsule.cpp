/// Reduction to finitely many times. Let the triangle be apart from the capsule at time 0, and
/// touch it first at time t. The distance of the triangle and the segment is continuous, so at time
/// t it equals the radius r. It is attained between points in the interiors of two features.
///
/// If r is positive, the triangle and the segment are disjoint, and the two features are a pair of
/// capsule_by_signs.hpp: if the edge and the segment are parallel, or if the triangle has
/// collapsed, the distance is also attained at an end or on an edge. The polynomial of this pair is
/// zero at t. It does not vanish identically. Otherwise the extended features would always have
/// distance r, their closest points would still be in the interiors of the features shortly before
/// t, and the triangle would then already touch the capsule.
///
/// If r is 0, the features have a common point. If this point is in the interior of the triangle
/// and of the segment, then either they cross there, which they would already do shortly before t,
/// or the segment lies in the plane of the triangle, or the triangle has collapsed; then another
/// common point is an end, or is on an edge. If it is in the interior of an edge and of the segment
/// and these are collinear, another common point is an end or a corner. Some pair of
/// capsule_by_signs.hpp remains, and its polynomial does not vanish identically, as above.
///
/// Conversely, the triangle touches the capsule at a root of the polynomial of a pair if the
/// closest points then belong to the features. The first time is thus the first such root, or
/// time 1.
///
/// Bits. Floats are multiples of 2^-149. The segment has coordinates below 2^128 and the triangle
/// below 2^61, so differences have at most 278 bits, and 212 between corners; they change by one
/// bit more. The longest coefficients are those of an edge and the segment: (w . n)^2, where n has
/// less than 2 * 2^(278 + 214), the coefficients of w . n less than 6 * 2^279 * 2^493 < 2^775, and
/// those of the square, which are sums of at most three products of these, less than 2^1552. The
/// other polynomials contain a difference from the segment at most four times in a product of four,
/// or twice in one of six.

#include "exact/scaled_float.hpp"
#include "geometry/triangle_distance.hpp"
#include "solid/capsule_by_signs.hpp"
#include "solid/moving_numbers.hpp"
#include "solid/region_triangle.hpp"

namespace pelt::detail {
namespace {

using SexticRoot = RootOf<Sextic>;

/// The corners of a moving triangle and the ends of a capsule's segment.
class MovingCapsule {
 public:
  MovingCapsule(const MovingTriangle& triangle, const Capsule& capsule) : radius_(capsule.radius) {
    for (std::size_t i = 0; i < 3; ++i) set(i, triangle.from[i], triangle.to[i]);
    set(3, capsule.a, capsule.a);
    set(4, capsule.b, capsule.b);
  }

  Vector<Rounded> from_to(std::size_t i, std::size_t j, const Rounded& time) const {
    const auto difference = [&](std::size_t axis) {
      return at_time(rounded(from_, axis, i, j), rounded(to_, axis, i, j), time);
    };
    return {difference(0), difference(1), difference(2)};
  }

  /// In the unit of all coordinates.
  Vector<Sextic> from_to(std::size_t i, std::size_t j) const {
    const auto difference = [&](std::size_t axis) {
      Sextic result;
      result.coefficients[0] = integer(from_[j][axis]) - integer(from_[i][axis]);
      result.coefficients[1] = integer(to_[j][axis]) - integer(to_[i][axis]);
      result.coefficients[1] -= result.coefficients[0];
      return result;
    };
    return {difference(0), difference(1), difference(2)};
  }

  Vector<RoundedPolynomial> rounded_from_to(std::size_t i, std::size_t j) const {
    const auto difference = [&](std::size_t axis) {
      RoundedPolynomial result;
      result.degree = 1;
      result.coefficients[0] = rounded(from_, axis, i, j);
      result.coefficients[1] = rounded(to_, axis, i, j) - result.coefficients[0];
      return result;
    };
    return {difference(0), difference(1), difference(2)};
  }

  float radius() const { return radius_; }

  Sextic radius_in_unit() const {
    Sextic result;
    result.coefficients[0] = integer(radius_);
    return result;
  }

 private:
  using Points = std::array<std::array<float, 3>, 5>;

  static Rounded rounded(const Points& points, std::size_t axis, std::size_t i, std::size_t j) {
    return Rounded(double{points[j][axis]}) - Rounded(double{points[i][axis]});
  }

  void set(std::size_t i, const Vec3& from, const Vec3& to) {
    from_[i] = {from.x, from.y, from.z};
    to_[i] = {to.x, to.y, to.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      include_in_unit(from_[i][axis]);
      include_in_unit(to_[i][axis]);
    }
  }

  void include_in_unit(float value) {
    if (value != 0) unit_ = std::min(unit_, OddTimesPower(value).exponent);
  }

  Sextic::Coefficient integer(float value) const { return scaled<Sextic::kBits>(value, unit_); }

  Points from_, to_;
  float radius_;
  int unit_ = radius_ != 0 ? OddTimesPower(radius_).exponent : 128;
};

/// `Signs`: RegionInstant or RegionPiece.
template <typename Signs>
class CapsuleSource {
 public:
  CapsuleSource(const MovingCapsule& moving, const Signs& signs) : moving_(moving), signs_(signs) {}

  template <typename Number>
  Vector<Number> from_to(std::size_t i, std::size_t j) const {
    if constexpr (std::is_same_v<Number, Rounded>) {
      return moving_.from_to(i, j, signs_.enclosure());
    } else if constexpr (std::is_same_v<Number, RoundedPolynomial>) {
      return moving_.rounded_from_to(i, j);
    } else {
      return moving_.from_to(i, j);
    }
  }

  template <typename Number>
  Number squared_radius() const {
    const Rounded rounded(double{moving_.radius()});
    if constexpr (std::is_same_v<Number, Rounded>) {
      return rounded * rounded;
    } else if constexpr (std::is_same_v<Number, RoundedPolynomial>) {
      RoundedPolynomial result;
      result.coefficients[0] = rounded * rounded;
      return result;
    } else {
      return moving_.radius_in_unit() * moving_.radius_in_unit();
    }
  }

  template <typename AnyPolynomial>
  int sign(const AnyPolynomial& polynomial) const {
    return signs_.sign(polynomial);
  }

 private:
  const MovingCapsule& moving_;
  const Signs& signs_;
};

/// Calls visit(pair) for all pairs of features.
template <typename Visit>
void for_each_pair(bool is_sphere, const Visit& visit) {
  for (std::uint8_t corner = 0; corner < 3; ++corner) {
    const auto pairs = pairs_of_corner(corner);
    for (std::size_t i = 0; i < (is_sphere ? 1 : pairs.size()); ++i) visit(pairs[i]);
  }
  for (std::size_t i = 0; i < (is_sphere ? 4 : kPairsOfEdgesAndFace.size()); ++i)
    visit(kPairsOfEdgesAndFace[i]);
}

class FirstTouchOfCapsule {
 public:
  FirstTouchOfCapsule(const MovingTriangle& triangle, const Capsule& capsule)
      : triangle_(triangle),
        capsule_(capsule),
        is_sphere_(capsule.a == capsule.b),
        moving_(triangle, capsule) {}

  std::optional<FirstTouch> run() {
    if (touches(triangle_.from)) return FirstTouch{0, true};
    for_each_pair(is_sphere_, [this](const CapsulePair& pair) { search(pair); });
    if (first_) return FirstTouch{first_->rounded_down(), false};
    if (touches(triangle_.to)) return FirstTouch{1, false};
    return std::nullopt;
  }

 private:
  bool touches(const TriangleCorners& corners) const {
    return place_triangle(corners, capsule_) != TrianglePlace::apart;
  }

  void search(const CapsulePair& pair) {
    if (beyond<RoundedPolynomial>(pair).certainly_has_no_root() || is_never_beside(pair)) return;
    RootsOf<Sextic> found;
    find_critical_times(beyond<Sextic>(pair), found);
    for (std::size_t i = 0; i < found.count; ++i) {
      const auto& [time, is_root] = found.entries[i];
      if (first_ && time.compare(*first_) >= 0) continue;
      if (is_near_at(time, is_root, pair)) first_ = time;
    }
  }

  template <typename Number>
  Number beyond(const CapsulePair& pair) const {
    const RegionInstant start(nullptr, Moment::at);
    const CapsuleSource source(moving_, start);
    return CapsuleBySigns(source, is_sphere_).template beyond<Number>(pair);
  }

  /// Whether the closest points certainly belong to the features at no time.
  bool is_never_beside(const CapsulePair& pair) const {
    const RegionPiece all(0, 1);
    const CapsuleSource source(moving_, all);
    return !CapsuleBySigns(source, is_sphere_).is_beside(pair) && all.take_certain();
  }

  /// `is_root`: whether the distance of the extended features certainly equals the radius.
  bool is_near_at(const SexticRoot& time, bool is_root, const CapsulePair& pair) const {
    const RegionInstant instant(&time, Moment::at);
    const CapsuleSource source(moving_, instant);
    const CapsuleBySigns test(source, is_sphere_);
    return is_root ? test.is_beside(pair) : test.is_near(pair);
  }

  const MovingTriangle& triangle_;
  const Capsule& capsule_;
  bool is_sphere_;
  MovingCapsule moving_;
  std::optional<SexticRoot> first_;
};

Vec3d corner_at(const Vec3& from, const Vec3& to, double time) {
  const Vec3d start(from);
  return start + time * (Vec3d(to) - start);
}

/// The part of w that is orthogonal to all of the given directions, of which two span their plane.
Vec3d orthogonal_part(const Vec3d& w, std::span<const Vec3d> directions) {
  if (directions.empty()) return w;
  const Vec3d& e = directions[0];
  if (directions.size() == 1) return w - (dot(w, e) / squared_length(e)) * e;
  const Vec3d n = cross(e, directions[1]);
  return (dot(w, n) / squared_length(n)) * n;
}

/// From the closest point of the segment to that of the triangle at a time. Which features they
/// belong to is found in float. In double, the way is then made orthogonal to these features,
/// because a direction with the error of a float would see a gap that is too small.
Vec3d way_to_triangle(const MovingTriangle& triangle, const TriangleCorners& segment, double time) {
  std::array<Vec3d, 3> at;
  TriangleCorners rounded;
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] = corner_at(triangle.from[i], triangle.to[i], time);
    rounded[i] = to_float(at[i]);
  }
  const ClosestPoints closest = closest_points(rounded, segment);
  std::array<Vec3d, 3> directions;
  std::size_t count = 0;
  std::size_t first = 0;
  while (closest.a[first] == 0) ++first;
  for (std::size_t i = first + 1; i < 3; ++i)
    if (closest.a[i] != 0) directions[count++] = at[i] - at[first];
  if (closest.b[0] != 0 && closest.b[0] != 1)
    directions[count++] = Vec3d(segment[1]) - Vec3d(segment[0]);
  const Vec3d w = closest.a[0] * at[0] + closest.a[1] * at[1] + closest.a[2] * at[2] -
                  point_at(segment, closest.b);
  return orthogonal_part(w, std::span(directions).first(count));
}

class CertainCapsule {
 public:
  CertainCapsule(const MovingTriangle& triangle, const Capsule& capsule)
      : triangle_(triangle),
        capsule_(capsule),
        is_sphere_(capsule.a == capsule.b),
        moving_(triangle, capsule) {}

  /// In the direction of the closest points at time `low`, the corners move away from the segment
  /// or towards it at constant speeds.
  double apart_until(double low) const {
    const Vec3d way = way_to_triangle(triangle_, {capsule_.a, capsule_.b, capsule_.b}, low);
    const Vector<Rounded> direction{Rounded(way.x), Rounded(way.y), Rounded(way.z)};
    const double reach = double{capsule_.radius} * std::sqrt(squared_length(way));
    for (const double margin : kRootMargins) {
      double until = 1;
      for_each_gap([&](std::size_t end, std::size_t corner) {
        until = std::min(until,
                         just_before_root(low, gap(direction, end, corner, low).value() - reach,
                                          gap(direction, end, corner, 1).value() - reach, margin));
      });
      if (until > low && is_beyond(direction, low) && is_beyond(direction, until)) return until;
    }
    return low;
  }

  bool touches(double time) const {
    const RegionPiece piece(time, time);
    const CapsuleSource source(moving_, piece);
    const CapsuleBySigns test(source, is_sphere_);
    bool is_near = false;
    for_each_pair(is_sphere_, [&](const CapsulePair& pair) {
      if (!is_near) is_near = test.is_near(pair) && piece.take_certain();
      piece.take_certain();
    });
    return is_near;
  }

 private:
  /// Calls visit(end, corner) for the ends of the segment and the corners of the triangle.
  template <typename Visit>
  void for_each_gap(const Visit& visit) const {
    for (std::size_t end = 3; end < (is_sphere_ ? 4 : 5); ++end)
      for (std::size_t corner = 0; corner < 3; ++corner) visit(end, corner);
  }

  Rounded gap(const Vector<Rounded>& direction, std::size_t end, std::size_t corner,
              double time) const {
    return dot(direction, moving_.from_to(end, corner, Rounded(time)));
  }

  /// Whether the triangle is certainly farther from the segment than the radius in a direction.
  bool is_beyond(const Vector<Rounded>& direction, double time) const {
    const Rounded radius(double{capsule_.radius});
    const Rounded limit = radius * radius * squared_length(direction);
    bool is_beyond = true;
    for_each_gap([&](std::size_t end, std::size_t corner) {
      const Rounded g = gap(direction, end, corner, time);
      if (g.sign() != 1 || (g * g - limit).sign() != 1) is_beyond = false;
    });
    return is_beyond;
  }

  const MovingTriangle& triangle_;
  const Capsule& capsule_;
  bool is_sphere_;
  MovingCapsule moving_;
};

}  // namespace

std::optional<FirstTouch> first_touch(const MovingTriangle& triangle, const Capsule& capsule) {
  return FirstTouchOfCapsule(triangle, capsule).run();
}

CertainAnswer certainly_touches(const MovingTriangle& triangle, const Capsule& capsule) {
  return certainly_touches(CertainCapsule(triangle, capsule));
}

bool find_certain_first_touch(const MovingTriangle& triangle, const Capsule& capsule,
                              std::optional<FirstTouch>& touch) {
  return find_certain_first_touch(CertainCapsule(triangle, capsule), touch);
}

}  // namespace pelt::detail
