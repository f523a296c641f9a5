#include "solid/prepared_region.hpp"

#include <pelt/math.hpp>

#include "base/assert.hpp"
#include "query/valid_numbers.hpp"
#include "solid/region_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pelt::detail {
namespace {

FloatFace to_float_face(const Face& face) {
  const Vec3& n = face.normal;
  const float largest = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  return {{std::ldexp(n.x, exponent), std::ldexp(n.y, exponent), std::ldexp(n.z, exponent)},
          {face.origin.x, face.origin.y, face.origin.z},
          std::ldexp(face.offset, exponent)};
}

Vec3 opposite(const Vec3& v) { return {-v.x, -v.y, -v.z}; }

void add_slab(const Vec3& normal, const Vec3& origin, float low, float high, FacesRegion& faces) {
  faces.add({normal, origin, high});
  faces.add({opposite(normal), origin, -low});
}

/// Converts each kind of region into one of the two forms.
struct Prepare {
  PreparedRegion& prepared;

  void operator()(const HalfSpace& half) const {
    prepared.faces.add({half.normal, {}, half.offset});
  }

  void operator()(const Box& box) const {
    add_slab({1, 0, 0}, {}, box.low.x, box.high.x, prepared.faces);
    add_slab({0, 1, 0}, {}, box.low.y, box.high.y, prepared.faces);
    add_slab({0, 0, 1}, {}, box.low.z, box.high.z, prepared.faces);
  }

  void operator()(const OrientedBox& box) const {
    const float half[] = {box.half.x, box.half.y, box.half.z};
    for (std::size_t i = 0; i < 3; ++i) {
      require(half[i] >= 0, "a half extent of the region is negative or NaN");
      add_slab(box.axes[i], box.centre, -half[i], half[i], prepared.faces);
    }
  }

  void operator()(const ConvexPolyhedron& polyhedron) const {
    for (const HalfSpace& face : polyhedron.faces()) (*this)(face);
  }

  void operator()(const Sphere& sphere) const {
    (*this)(Capsule{sphere.centre, sphere.centre, sphere.radius});
  }

  void operator()(const Capsule& capsule) const {
    require(is_finite(capsule.a) && is_finite(capsule.b),
            "a point of the region is NaN or infinite");
    require(std::isfinite(capsule.radius) && capsule.radius >= 0,
            "the radius of the region is negative, NaN or infinite");
    prepared.is_capsule = true;
    prepared.capsule.capsule = capsule;
    const float a[] = {capsule.a.x, capsule.a.y, capsule.a.z};
    const float b[] = {capsule.b.x, capsule.b.y, capsule.b.z};
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      prepared.capsule.low[axis] =
          std::nextafter(std::min(a[axis], b[axis]) - capsule.radius, -kInfinity);
      prepared.capsule.high[axis] =
          std::nextafter(std::max(a[axis], b[axis]) + capsule.radius, kInfinity);
    }
  }
};

void check_solid(const HalfSpace& half) {
  require(!is_zero(half.normal), "the normal of the half-space is zero");
}

void check_solid(const Box& box) {
  require(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z,
          "the low corner of the box is above its high corner, or NaN");
}

template <typename Shape>
void check_solid(const Shape&) {}

}  // namespace

void FacesRegion::add(const Face& face) {
  PELT_ASSERT(count < ConvexPolyhedron::kMaxFaces);
  require(is_finite(face.normal) && is_finite(face.origin) && std::isfinite(face.offset),
          "a number of the region is NaN or infinite");
  exact[count] = face;
  scaled[count] = to_float_face(face);
  ++count;
}

TrianglePlace place_in(const FacesRegion& region, const TriangleCorners& triangle) {
  return place_triangle(triangle, std::span(region.exact, region.count));
}

TrianglePlace place_in(const CapsuleRegion& region, const TriangleCorners& triangle) {
  return place_triangle(triangle, region.capsule);
}

PreparedRegion::PreparedRegion(const Region& region) { std::visit(Prepare{*this}, region); }

Region region_of(const Solid& solid) {
  return std::visit(
      [](const auto& shape) {
        check_solid(shape);
        return Region(shape);
      },
      solid);
}

}  // namespace pelt::detail

namespace pelt {
namespace {

/// A clip coordinate as a linear function of (p, 1).
struct Row {
  double x, y, z, w;

  Row(const Matrix4& m, std::size_t row)
      : Row(static_cast<double>(m.m[row]), static_cast<double>(m.m[4 + row]),
            static_cast<double>(m.m[8 + row]), static_cast<double>(m.m[12 + row])) {}
  Row(double x_, double y_, double z_, double w_) : x(x_), y(y_), z(z_), w(w_) {}

  Row operator+(const Row& other) const {
    return {x + other.x, y + other.y, z + other.z, w + other.w};
  }
  Row operator-(const Row& other) const {
    return {x - other.x, y - other.y, z - other.z, w - other.w};
  }
};

/// Returns the half-space in which the function is not negative.
HalfSpace where_positive(const Row& row) {
  return {{static_cast<float>(-row.x), static_cast<float>(-row.y), static_cast<float>(-row.z)},
          static_cast<float>(row.w)};
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(std::span<const HalfSpace> faces) : count_(faces.size()) {
  detail::require(faces.size() <= kMaxFaces,
                  "ConvexPolyhedron: more than 64 faces; leave out those that cut nothing off");
  std::copy(faces.begin(), faces.end(), faces_.begin());
}

Frustum make_frustum(const Matrix4& view_projection, ClipDepth depth) {
  const Row x(view_projection, 0), y(view_projection, 1), z(view_projection, 2),
      w(view_projection, 3);
  const Row from_near = depth == ClipDepth::zero_to_one ? z : w + z;
  return {{where_positive(w + x), where_positive(w - x), where_positive(w + y),
           where_positive(w - y), where_positive(from_near), where_positive(w - z)}};
}

}  // namespace pelt
