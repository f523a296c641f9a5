#include "distance/triangle_gaps.hpp"

#include "base/double4.hpp"
#include "geometry/triangle_distance.hpp"

#include <cfloat>
#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Returns one corner of each of the eight triangles starting at `first`.
Points8 corner8(const PosedCluster& cluster, std::uint32_t first, std::size_t corner) {
  const auto* corners = cluster.posed.tree.corners.data() + cluster.cluster().first_triangle;
  const std::uint32_t last = cluster.cluster().triangle_count - 1u;
  const auto at = [&](std::uint32_t lane) {
    const std::uint32_t triangle = first + lane < last ? first + lane : last;
    return load4(cluster.opened.positions + corners[triangle][corner]);
  };
  return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
}

Float8 place(const Points8& p, const Vec3& direction, const Vec3& origin) {
  return (p.x - Float8(origin.x)) * Float8(direction.x) +
         (p.y - Float8(origin.y)) * Float8(direction.y) +
         (p.z - Float8(origin.z)) * Float8(direction.z);
}

/// Applies `choose` to the values of each triangle's corners.
template <typename Choose>
TriangleValues places(const PosedCluster& cluster, const Vec3& direction, const Vec3& origin,
                      const Choose& choose) {
  TriangleValues values;
  for (std::uint32_t first = 0; first < kMaxClusterTriangles; first += 8) {
    const Float8 a = place(corner8(cluster, first, 0), direction, origin);
    const Float8 b = place(corner8(cluster, first, 1), direction, origin);
    const Float8 c = place(corner8(cluster, first, 2), direction, origin);
    choose(choose(a, b), c).store(values.of + first);
  }
  return values;
}

/// Twice the middle of the cluster's box on an axis.
double middle(const PosedCluster& cluster, int axis) {
  return double{cluster.opened.low[axis][cluster.slot]} + cluster.opened.high[axis][cluster.slot];
}

}  // namespace

TriangleValues Along::lowest(const PosedCluster& cluster) const {
  return places(cluster, direction_, origin_,
                [](const Float8& x, const Float8& y) { return min(x, y); });
}

TriangleValues Along::highest(const PosedCluster& cluster) const {
  return places(cluster, direction_, origin_,
                [](const Float8& x, const Float8& y) { return max(x, y); });
}

std::uint32_t lowest_of(const TriangleValues& values) {
  std::uint32_t lowest = 0;
  for (std::uint32_t i = 1; i < kMaxClusterTriangles; ++i)
    if (values.of[i] < values.of[lowest]) lowest = i;
  return lowest;
}

std::uint32_t highest_of(const TriangleValues& values) {
  std::uint32_t highest = 0;
  for (std::uint32_t i = 1; i < kMaxClusterTriangles; ++i)
    if (values.of[i] > values.of[highest]) highest = i;
  return highest;
}

unsigned up_to(const TriangleValues& values, float most) {
  const Float8 limit(most);
  return (load8(values.of) <= limit).bits() | (load8(values.of + 8) <= limit).bits() << 8;
}

TriangleCorners corners_of(const PosedCluster& cluster, std::uint32_t place) {
  TriangleCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = cluster.opened.positions + cluster.posed.tree.corners.data()[place][k];
    corners[k] = {p[0], p[1], p[2]};
  }
  return corners;
}

float gap_error(const PosedCluster& a, const PosedCluster& b, const Vec3& origin) {
  const float from[3] = {origin.x, origin.y, origin.z};
  float most = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const PosedCluster* cluster : {&a, &b}) {
      const float low = std::fabs(cluster->opened.low[axis][cluster->slot] - from[axis]);
      const float high = std::fabs(cluster->opened.high[axis][cluster->slot] - from[axis]);
      const float larger = low > high ? low : high;
      most = larger > most ? larger : most;
    }
  return 48 * 0x1p-24f * most + 0x1p-120f;
}

Vec3 low_corner(const PosedCluster& cluster) {
  return {cluster.opened.low[0][cluster.slot], cluster.opened.low[1][cluster.slot],
          cluster.opened.low[2][cluster.slot]};
}

Vec3 direction_between(const PosedCluster& a, const PosedCluster& b) {
  return direction_of(
      {middle(b, 0) - middle(a, 0), middle(b, 1) - middle(a, 1), middle(b, 2) - middle(a, 2)});
}

Vec3 direction_of(const Vec3d& way) {
  const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  if (!(length > 0)) return {};
  return {static_cast<float>(way.x / length), static_cast<float>(way.y / length),
          static_cast<float>(way.z / length)};
}

namespace {

// The arithmetic of triangle_distance.cpp, operation by operation, for four pairs of triangles in
// parallel, with selections instead of branches. Does not compute barycentrics.

/// The quotient, clamped to [0, 1].
Double4 share(const Double4& dividend, const Double4& divisor) {
  return max(min(dividend / divisor, Double4(1.0)), Double4(0.0));
}

/// Whether 0 < x < limit.
MaskDouble4 is_inside(const Double4& x, const Double4& limit) {
  return (Double4(0.0) < x) & (x < limit);
}

struct Normal4 {
  Normal4(const Vec3d4& u, const Double4& squared_u, const Vec3d4& v, const Double4& squared_v)
      : direction(cross(u, v)),
        squared(squared_length(direction)),
        squared_error(Double4(0x1p-81) * squared_u * squared_v) {}

  Vec3d4 direction;
  Double4 squared, squared_error;
};

struct Face4 {
  explicit Face4(const Vec3d4 (&t)[3])
      : corner{t[0], t[1], t[2]},
        edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]},
        side(t[2] - t[0]),
        squared_edge{squared_length(edge[0]), squared_length(edge[1]), squared_length(edge[2])},
        normal(edge[0], squared_edge[0], side, squared_edge[2]) {}

  Vec3d4 corner[3], edge[3], side;
  Double4 squared_edge[3];
  Normal4 normal;
};

class LeastOfFaces {
 public:
  LeastOfFaces(const Face4& a, const Face4& b) : a_(a), b_(b) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        way_[i][j] = b.corner[j] - a.corner[i];
        squared_way_[i][j] = squared_length(way_[i][j]);
        try_corners(i, j);
      }
    for (int i = 0; i < 3; ++i) {
      try_inside(a.corner[i], b, may_be_nearer(b.normal, i, 0));
      try_inside(b.corner[i], a, may_be_nearer(a.normal, 0, i));
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) try_edges(i, j);
  }

  Double4 squared() const { return squared_; }

 private:
  void keep(const Double4& squared) { squared_ = min(squared, squared_); }

  void keep(const Double4& squared, const MaskDouble4& where) {
    squared_ = select((squared < squared_) & where, squared, squared_);
  }

  void try_corners(int i, int j) {
    const Vec3d4& w = way_[i][j];
    const Double4 on_b = share(-dot(w, b_.edge[j]), b_.squared_edge[j]);
    keep(squared_length(w + on_b * b_.edge[j]));
    const Double4 on_a = share(dot(w, a_.edge[i]), a_.squared_edge[i]);
    keep(squared_length(w - on_a * a_.edge[i]));
  }

  MaskDouble4 may_be_nearer(const Normal4& n, int i, int j) const {
    const Double4 along = dot(way_[i][j], n.direction);
    return along * along <
           squared_ * (Double4(1 + 0x1p-10) * n.squared) + n.squared_error * squared_way_[i][j];
  }

  void try_inside(const Vec3d4& point, const Face4& face, const MaskDouble4& where) {
    const Vec3d4 w = point - face.corner[0], &u = face.edge[0];
    const Double4 t_dividend = dot(cross(u, w), face.normal.direction);
    const MaskDouble4 t_is_inside = where & is_inside(t_dividend, face.normal.squared);
    if (!t_is_inside.any()) return;
    const Double4 t = t_dividend / face.normal.squared;
    const Vec3d4 rest = w - t * face.side;
    const Double4 s_dividend = dot(rest, u);
    const Double4 s_limit = (Double4(1.0) - t) * face.squared_edge[0];
    const Double4 s = s_dividend / face.squared_edge[0];
    keep(squared_length(rest - s * u), t_is_inside & is_inside(s_dividend, s_limit));
  }

  void try_edges(int i, int j) {
    const Vec3d4 &w = way_[i][j], &u = a_.edge[i], &v = b_.edge[j];
    const Normal4 n(u, a_.squared_edge[i], v, b_.squared_edge[j]);
    const Double4 s_dividend = dot(cross(w, v), n.direction);
    const MaskDouble4 s_is_inside = may_be_nearer(n, i, j) & is_inside(s_dividend, n.squared);
    if (!s_is_inside.any()) return;
    const Vec3d4 rest = s_dividend / n.squared * u - w;
    const Double4 t_dividend = dot(rest, v), t = t_dividend / b_.squared_edge[j];
    keep(squared_length(rest - t * v), s_is_inside & is_inside(t_dividend, b_.squared_edge[j]));
  }

  const Face4 &a_, &b_;
  Vec3d4 way_[3][3];
  Double4 squared_way_[3][3];
  Double4 squared_ = Double4(HUGE_VAL);
};

/// The first or the last four of eight triangles.
template <typename Half>
Face4 face4(const Points8 (&corners)[3], const Half& half) {
  Vec3d4 t[3];
  for (int i = 0; i < 3; ++i)
    t[i] = {Double4(half(corners[i].x)), Double4(half(corners[i].y)), Double4(half(corners[i].z))};
  return Face4(t);
}

struct Interval8 {
  Float8 low, high;
};

Interval8 interval(const Float8& a, const Float8& b, const Float8& c) {
  return {min(min(a, b), c), max(max(a, b), c)};
}

Float8 gap(const Interval8& a, const Interval8& b) {
  return max(max(a.low - b.high, b.low - a.high), Float8(0.0f));
}

Float8 least_squared_distances(const Points8 (&a)[3], const Points8 (&b)[3]) {
  const Float8 x = gap(interval(a[0].x, a[1].x, a[2].x), interval(b[0].x, b[1].x, b[2].x));
  const Float8 y = gap(interval(a[0].y, a[1].y, a[2].y), interval(b[0].y, b[1].y, b[2].y));
  const Float8 z = gap(interval(a[0].z, a[1].z, a[2].z), interval(b[0].z, b[1].z, b[2].z));
  return (x * x + y * y + z * z) * Float8(kBoxGapShare) - Float8(kBoxGapUnderflow);
}

/// `least`: of all eight pairs.
template <typename Half>
void measure(const TrianglePairs8& pairs, const Float8& least, const Half& half, double* squared) {
  const Face4 a = face4(pairs.a, half), b = face4(pairs.b, half);
  const Double4 most = max(LeastOfFaces(a, b).squared(), Double4(half(least)));
  max(most, Double4(DBL_MIN)).store(squared);
}

}  // namespace

void squared_distances(const TrianglePairs8& pairs, std::uint32_t count, double (&squared)[8]) {
  const Float8 least = least_squared_distances(pairs.a, pairs.b);
  measure(
      pairs, least, [](const Float8& v) { return v.low(); }, squared);
  if (count > 4)
    measure(
        pairs, least, [](const Float8& v) { return v.high(); }, squared + 4);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
