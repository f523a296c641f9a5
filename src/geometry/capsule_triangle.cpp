/// A triangle touches a capsule if it intersects the capsule's segment or is within the radius of
/// the segment. The distance between a triangle and a disjoint segment is attained between two
/// features, in the interior of each: a vertex or end against a vertex, end, edge or face, or an
/// edge against the segment (Ericson 2005, 5.1.9 and 5.1.10). Each pair is tested without division.
/// With w from one feature to the other and the radius r, the closest points are within r if
///
///   vertices        (w . w) <= r^2
///   along an edge e, at t = (w . e) / (e . e) in [0, 1]: (w . w - r^2) (e . e) <= (w . e)^2
///   on a face with the normal n, if the projection is inside: (w . n)^2 <= r^2 (n . n)
///   of two edges d and e, n = d x e, at (w x e . n) / (n . n) and (w x d . n) / (n . n) in [0, 1]:
///                   (w . n)^2 <= r^2 (n . n)
///
/// The degree of these polynomials is at most six. The triangle is inside if its vertices are
/// inside, because a capsule is convex.

#include "geometry/capsule_triangle.hpp"

#include "geometry/exact_number.hpp"

namespace pelt::detail {
namespace {

template <typename Number>
Number square(const Number& a) {
  return a * a;
}

template <typename Number>
Number to(float value) {
  return Number(static_cast<double>(value));
}

template <typename Number>
Vector<Number> from_to(const Vec3& a, const Vec3& b) {
  return Vector<Number>(b) - Vector<Number>(a);
}

class CapsuleTest {
 public:
  CapsuleTest(const TriangleCorners& triangle, const Capsule& capsule)
      : t_(triangle), a_(capsule.a), b_(capsule.b), radius_(capsule.radius) {}

  TrianglePlace run() const {
    int inside = 0;
    for (const Vec3& corner : t_) inside += has(corner);
    if (inside == 3) return TrianglePlace::inside;
    if (inside > 0 || is_end_near(a_)) return TrianglePlace::touching;
    if (a_ == b_) return TrianglePlace::apart;
    return is_end_near(b_) || is_any_edge_near() || triangles_intersect({a_, b_, b_}, t_)
               ? TrianglePlace::touching
               : TrianglePlace::apart;
  }

 private:
  bool has(const Vec3& p) const {
    return are_near(p, a_) || (a_ != b_ && (are_near(p, b_) || is_near_inside(p, a_, b_)));
  }

  /// Whether a point is near the interior of an edge or of the face.
  bool is_end_near(const Vec3& end) const {
    return is_near_inside(end, t_[0], t_[1]) || is_near_inside(end, t_[1], t_[2]) ||
           is_near_inside(end, t_[2], t_[0]) || is_near_face(end);
  }

  bool is_any_edge_near() const {
    return are_near_inside(t_[0], t_[1]) || are_near_inside(t_[1], t_[2]) ||
           are_near_inside(t_[2], t_[0]);
  }

  template <typename Number>
  Number squared_radius() const {
    return square(to<Number>(radius_));
  }

  bool are_near(const Vec3& p, const Vec3& q) const {
    return exact_sign([&]<typename Number>(const Number&) {
             return squared_length(from_to<Number>(p, q)) - squared_radius<Number>();
           }) <= 0;
  }

  /// Whether the point of the edge pq closest to `c` is inside the edge, and within the radius.
  bool is_near_inside(const Vec3& c, const Vec3& p, const Vec3& q) const {
    const auto along = [&]<typename Number>(const Number&) {
      return dot(from_to<Number>(p, c), from_to<Number>(p, q));
    };
    const auto left = [&]<typename Number>(const Number& number) {
      return squared_length(from_to<Number>(p, q)) - along(number);
    };
    const auto distance = [&]<typename Number>(const Number& number) {
      return (squared_length(from_to<Number>(p, c)) - squared_radius<Number>()) *
                 squared_length(from_to<Number>(p, q)) -
             square(along(number));
    };
    return exact_sign(along) > 0 && exact_sign(left) > 0 && exact_sign(distance) <= 0;
  }

  /// Whether the point of the triangle's plane closest to `c` is in the triangle, and within the
  /// radius.
  bool is_near_face(const Vec3& c) const {
    const auto normal = [&]<typename Number>(const Number&) {
      return cross(from_to<Number>(t_[0], t_[1]), from_to<Number>(t_[0], t_[2]));
    };
    const auto distance = [&]<typename Number>(const Number& number) {
      const Vector<Number> n = normal(number);
      return square(dot(from_to<Number>(t_[0], c), n)) -
             squared_radius<Number>() * squared_length(n);
    };
    if (exact_sign([&](const auto& number) { return squared_length(normal(number)); }) == 0)
      return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (exact_sign([&]<typename Number>(const Number& number) {
            const Vec3 &p = t_[k], &q = t_[(k + 1) % 3];
            return dot(normal(number), cross(from_to<Number>(p, q), from_to<Number>(p, c)));
          }) < 0)
        return false;
    return exact_sign(distance) <= 0;
  }

  /// Whether the closest points of the capsule's segment and the edge pq are inside both, and
  /// within the radius.
  bool are_near_inside(const Vec3& p, const Vec3& q) const {
    const auto squared_normal = [&]<typename Number>(const Number&) {
      return squared_length(normal_of<Number>(p, q));
    };
    const auto at = [&]<typename Number>(const Vec3& from, const Vec3& to, const Number&) {
      return dot(cross(from_to<Number>(a_, p), from_to<Number>(from, to)), normal_of<Number>(p, q));
    };
    const auto on_segment = [&](const auto& number) { return at(p, q, number); };
    const auto on_edge = [&](const auto& number) { return at(a_, b_, number); };
    const auto distance = [&]<typename Number>(const Number&) {
      const Vector<Number> n = normal_of<Number>(p, q);
      return square(dot(from_to<Number>(a_, p), n)) - squared_radius<Number>() * squared_length(n);
    };
    const auto is_inside = [&](const auto& place) {
      return exact_sign(place) >= 0 && exact_sign([&](const auto& number) {
                                         return squared_normal(number) - place(number);
                                       }) >= 0;
    };
    return exact_sign(squared_normal) > 0 && is_inside(on_segment) && is_inside(on_edge) &&
           exact_sign(distance) <= 0;
  }

  template <typename Number>
  Vector<Number> normal_of(const Vec3& p, const Vec3& q) const {
    return cross(from_to<Number>(a_, b_), from_to<Number>(p, q));
  }

  const TriangleCorners& t_;
  const Vec3 &a_, &b_;
  float radius_;
};

}  // namespace

TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule) {
  return CapsuleTest(triangle, capsule).run();
}

}  // namespace pelt::detail
