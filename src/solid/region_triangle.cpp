#include "solid/region_triangle.hpp"

#include "solid/capsule_by_signs.hpp"
#include "solid/faces_by_signs.hpp"

namespace pelt::detail {
namespace {

class StillFaces {
 public:
  StillFaces(const TriangleCorners& triangle, std::span<const Face> faces)
      : triangle_(triangle), faces_(faces) {}

  template <typename Number>
  Number side(std::size_t face, std::size_t corner) const {
    const Face& f = faces_[face];
    return dot(Vector<Number>(f.normal),
               Vector<Number>(triangle_[corner]) - Vector<Number>(f.origin)) -
           Number(static_cast<double>(f.offset));
  }

  template <typename Polynomial>
  int sign(const Polynomial& polynomial) const {
    return exact_sign(polynomial);
  }

 private:
  const TriangleCorners& triangle_;
  std::span<const Face> faces_;
};

}  // namespace

TrianglePlace place_triangle(const TriangleCorners& triangle, std::span<const Face> faces) {
  const StillFaces source(triangle, faces);
  return FacesBySigns(source).place(faces.size());
}

namespace {

/// A triangle touches a capsule if it intersects the capsule's segment or is within the radius of
/// the segment (capsule_by_signs.hpp). The triangle is inside if its vertices are inside, because a
/// capsule is convex.
class StillCapsule {
 public:
  StillCapsule(const TriangleCorners& t, const Capsule& capsule)
      : points_{&t[0], &t[1], &t[2], &capsule.a, &capsule.b}, radius_(capsule.radius) {}

  template <typename Number>
  Vector<Number> from_to(std::size_t i, std::size_t j) const {
    return Vector<Number>(*points_[j]) - Vector<Number>(*points_[i]);
  }

  template <typename Number>
  Number squared_radius() const {
    const Number radius(static_cast<double>(radius_));
    return radius * radius;
  }

  template <typename Polynomial>
  int sign(const Polynomial& polynomial) const {
    return exact_sign(polynomial);
  }

 private:
  std::array<const Vec3*, 5> points_;
  float radius_;
};

}  // namespace

TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule) {
  const StillCapsule source(triangle, capsule);
  const bool is_sphere = capsule.a == capsule.b;
  const CapsuleBySigns test(source, is_sphere);
  int inside = 0;
  for (std::uint8_t corner = 0; corner < 3; ++corner) inside += test.is_inside(corner);
  if (inside == 3) return TrianglePlace::inside;
  if (inside > 0 || test.is_edge_or_face_near()) return TrianglePlace::touching;
  return !is_sphere && triangles_intersect({capsule.a, capsule.b, capsule.b}, triangle)
             ? TrianglePlace::touching
             : TrianglePlace::apart;
}

}  // namespace pelt::detail
