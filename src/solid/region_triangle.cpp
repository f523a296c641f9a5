#include "solid/region_triangle.hpp"

#include "solid/capsule_by_signs.hpp"
#include "solid/faces_by_signs.hpp"
#include "solid/prepared_region.hpp"

#include <span>

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

namespace {

// The stages of the decision about a moving triangle.
//
// `AnyRegion`: faces or a capsule. The triangle is apart from the region at time 0.

template <typename AnyRegion>
std::optional<FirstTouch> decide_whether(const AnyRegion& region, const MovingTriangle& triangle,
                                         MovingStats& work) {
  CertainAnswer answer = certainly_touches(triangle, region);
  if (answer == CertainAnswer::unknown) {
    ++work.exact_pairs;
    answer = first_touch(triangle, region) ? CertainAnswer::yes : CertainAnswer::no;
  }
  if (answer == CertainAnswer::no) return std::nullopt;
  return FirstTouch{};
}

template <typename AnyRegion>
std::optional<FirstTouch> decide_when(const AnyRegion& region, const MovingTriangle& triangle,
                                      MovingStats& work) {
  std::optional<FirstTouch> touch;
  if (find_certain_first_touch(triangle, region, touch)) return touch;
  ++work.exact_pairs;
  return first_touch(triangle, region);
}

template <typename AnyRegion>
std::optional<FirstTouch> decide(const AnyRegion& region, const MovingTriangle& triangle,
                                 const MovingOptions& options, MovingStats& work) {
  const auto touches = [&](const TriangleCorners& corners) {
    return place_triangle(corners, region) != TrianglePlace::apart;
  };
  ++work.triangle_pairs;
  if (touches(triangle.from)) {
    if (options.leave_out_start) return std::nullopt;
    return FirstTouch{0, true};
  }
  if (!options.times && touches(triangle.to)) return FirstTouch{};
  ++work.double_pairs;
  return options.times ? decide_when(region, triangle, work)
                       : decide_whether(region, triangle, work);
}

}  // namespace

std::optional<FirstTouch> decide_touch(const FacesRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work) {
  return decide(std::span<const Face>(region.exact, region.count), triangle, options, work);
}

std::optional<FirstTouch> decide_touch(const CapsuleRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work) {
  return decide(region.capsule, triangle, options, work);
}

}  // namespace pelt::detail
