/// The closest points of two triangles that do not touch include a vertex of one, or are inside an
/// edge of each. The distance is therefore the least over vertices against edges and faces, and
/// edges against edges.
///
/// Rounding. Let e = 2^-53 and S as in the header. Candidates are points of the triangles, written
/// as a difference w - s u - t v of vectors with |s|, |t| <= 1, so the distance of a candidate has
/// an error of a few e S. It remains to bound how far a candidate is from the closest point.
///   Vertex against edge: the position along the edge has an error of a few e S; at the closest
/// point this changes the distance to second order only.
///   Edge against edge, u and v at an angle x: with n = u x v, s = (w x v).n / n.n has an error of
/// a few e S / (|u| x). The point on v is then the closest to the point on u, so its distance from
/// the closest point is x |u| times that: a few e S. (With the normal equations, the error of s
/// would be larger by a factor 1/x; this is why cross products are used.)
///   Vertex against face: in w = s u + t v + (normal part), t is computed from cross products and s
/// then by projection onto u. The candidate has the same accuracy as long as n has a direction:
/// with h the height over u and d the distance, n has an error of an angle e S / h, and the
/// candidate an error of d e S / h, which increases d by at most d (e S / h)^2 / 2. But an edge is
/// never farther than h from the closest point, and increases d by at most h^2 / 2 d. The smaller
/// of both is at most e S / 2.
///   Skipped candidates. A plane, or two lines, with the normal n = u x v is skipped if w.n shows
/// that it is no nearer than the best candidate so far, at distance d. n has an error of at most
/// 15 e |u| |v|, and w.n of at most 49 e |u| |v| |w|. w leads from corner to corner, so d <= |w| up
/// to rounding. Therefore w.n must be at least x + y, with x = d |n| and y = 2^-46 |u| |v| |w|. By
/// (x + y)^2 <= (1 + 2^-10) x^2 + (1 + 2^10) y^2, squares decide this. (For a sliver with a distant
/// corner, y can be more than w.n: nothing is skipped.)
#include "geometry/triangle_distance.hpp"

#include <cstddef>
#include <limits>

namespace pelt::detail {
namespace {

/// `dividend` / `divisor`, clamped to [0, 1]; 0 if the divisor is 0.
double share(double dividend, double divisor) {
  if (!(dividend > 0)) return 0;
  return dividend < divisor ? dividend / divisor : divisor > 0 ? 1 : 0;
}

/// The normal of two directions.
struct Normal {
  Normal() = default;
  Normal(const Vec3d& u, double squared_u, const Vec3d& v, double squared_v)
      : direction(cross(u, v)),
        squared(squared_length(direction)),
        squared_error(0x1p-81 * squared_u * squared_v) {}

  Vec3d direction;
  double squared;        ///< of the length
  double squared_error;  ///< see above; to be multiplied by |w|^2
};

/// A triangle with precomputed values.
struct Face {
  explicit Face(const TriangleCorners& t) : corner{Vec3d(t[0]), Vec3d(t[1]), Vec3d(t[2])} {
    for (std::size_t i = 0; i < 3; ++i) {
      edge[i] = corner[(i + 1) % 3] - corner[i];
      squared_edge[i] = squared_length(edge[i]);
    }
    side = corner[2] - corner[0];
    normal = Normal(edge[0], squared_edge[0], side, squared_edge[2]);
  }

  Vec3d corner[3];
  Vec3d edge[3];  ///< edge i leads from corner i to the next
  Vec3d side;     ///< from corner 0 to corner 2
  Normal normal;
  double squared_edge[3];
};

Barycentrics on_edge(std::size_t edge, double s) {
  Barycentrics at = {};
  at[edge] = 1 - s;
  at[(edge + 1) % 3] = s;
  return at;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The projection of a point onto a face; infinitely far if the projection is outside the face.
ClosestOnTriangle closest_inside(const Vec3d& point, const Face& face) {
  constexpr ClosestOnTriangle kNone = {kInfinity, {1, 0, 0}};
  const Vec3d w = point - face.corner[0], &u = face.edge[0], &v = face.side;
  const double t_dividend = dot(cross(u, w), face.normal.direction);
  if (!(t_dividend > 0 && t_dividend < face.normal.squared)) return kNone;
  const double t = t_dividend / face.normal.squared;
  const Vec3d rest = w - t * v;
  const double s_dividend = dot(rest, u);
  if (!(s_dividend > 0 && s_dividend < (1 - t) * face.squared_edge[0])) return kNone;
  const double s = s_dividend / face.squared_edge[0], first = 1 - t - s;
  return {squared_length(rest - s * u), {first > 0 ? first : 0, s, t}};
}

ClosestOnTriangle closest_on(const Vec3d& point, const Face& face) {
  ClosestOnTriangle closest = closest_inside(point, face);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d w = point - face.corner[i];
    const double s = share(dot(w, face.edge[i]), face.squared_edge[i]);
    const double squared = squared_length(w - s * face.edge[i]);
    if (squared < closest.squared_distance) closest = {squared, on_edge(i, s)};
  }
  return closest;
}

Barycentrics at_corner(std::size_t corner) {
  Barycentrics at = {};
  at[corner] = 1;
  return at;
}

/// The closest points of two faces so far.
///
/// If the lines of two edges, or a corner and the plane of a face, are no nearer than the best
/// points so far, their points need not be computed. This saves most of the work.
class ClosestOfFaces {
 public:
  ClosestOfFaces(const Face& a, const Face& b) : a_(a), b_(b) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        way_[i][j] = b.corner[j] - a.corner[i];
        squared_way_[i][j] = squared_length(way_[i][j]);
        try_corner_of_a(i, j);
        try_corner_of_b(i, j);
      }
    for (std::size_t i = 0; i < 3; ++i) {
      if (may_be_nearer(b.normal, i, 0)) keep_on_b(at_corner(i), closest_inside(a.corner[i], b));
      if (may_be_nearer(a.normal, 0, i)) keep_on_a(closest_inside(b.corner[i], a), at_corner(i));
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) try_edges(i, j);
  }

  /// Tries the points where edges of one face pierce the other.
  void try_piercings() {
    for (std::size_t i = 0; i < 3; ++i) {
      if (const double s = piercing(a_, i, b_); s >= 0)
        keep_on_b(on_edge(i, s), closest_on(a_.corner[i] + s * a_.edge[i], b_));
      if (const double s = piercing(b_, i, a_); s >= 0)
        keep_on_a(closest_on(b_.corner[i] + s * b_.edge[i], a_), on_edge(i, s));
    }
  }

  const ClosestPoints& result() const { return closest_; }

 private:
  void keep_on_b(const Barycentrics& a, const ClosestOnTriangle& b) {
    if (b.squared_distance < closest_.squared_distance) closest_ = {b.squared_distance, a, b.at};
  }

  void keep_on_a(const ClosestOnTriangle& a, const Barycentrics& b) {
    if (a.squared_distance < closest_.squared_distance) closest_ = {a.squared_distance, a.at, b};
  }

  /// Tries corner i of the first face with edge j of the second.
  void try_corner_of_a(std::size_t i, std::size_t j) {
    const Vec3d& w = way_[i][j];
    const double s = share(-dot(w, b_.edge[j]), b_.squared_edge[j]);
    const double squared = squared_length(w + s * b_.edge[j]);
    if (squared < closest_.squared_distance) closest_ = {squared, at_corner(i), on_edge(j, s)};
  }

  /// Tries edge i of the first face with corner j of the second.
  void try_corner_of_b(std::size_t i, std::size_t j) {
    const Vec3d& w = way_[i][j];
    const double s = share(dot(w, a_.edge[i]), a_.squared_edge[i]);
    const double squared = squared_length(w - s * a_.edge[i]);
    if (squared < closest_.squared_distance) closest_ = {squared, on_edge(i, s), at_corner(j)};
  }

  /// Whether a plane or two lines may be nearer than the best points so far. The way from corner i
  /// to corner j leads from one of the two to the other.
  bool may_be_nearer(const Normal& n, std::size_t i, std::size_t j) const {
    const double along = dot(way_[i][j], n.direction);
    return along * along < closest_.squared_distance * ((1 + 0x1p-10) * n.squared) +
                               n.squared_error * squared_way_[i][j];
  }

  /// Tries points inside both edges; points at ends have been tried before.
  void try_edges(std::size_t i, std::size_t j) {
    const Vec3d &w = way_[i][j], &u = a_.edge[i], &v = b_.edge[j];
    const Normal n(u, a_.squared_edge[i], v, b_.squared_edge[j]);
    if (!may_be_nearer(n, i, j)) return;
    const double s_dividend = dot(cross(w, v), n.direction);
    if (!(s_dividend > 0 && s_dividend < n.squared)) return;
    const double s = s_dividend / n.squared;
    const Vec3d rest = s * u - w;
    const double t_dividend = dot(rest, v);
    if (!(t_dividend > 0 && t_dividend < b_.squared_edge[j])) return;
    const double t = t_dividend / b_.squared_edge[j];
    const double squared = squared_length(rest - t * v);
    if (squared < closest_.squared_distance) closest_ = {squared, on_edge(i, s), on_edge(j, t)};
  }

  /// The position on an edge where it crosses the other's plane; negative if both ends are on one
  /// side.
  static double piercing(const Face& of, std::size_t edge, const Face& face) {
    const double begin = dot(face.normal.direction, of.corner[edge] - face.corner[0]);
    const double end = dot(face.normal.direction, of.corner[(edge + 1) % 3] - face.corner[0]);
    return (begin < 0) == (end < 0) ? -1 : begin / (begin - end);
  }

  const Face &a_, &b_;
  Vec3d way_[3][3];  ///< from corners of the first face to those of the second
  double squared_way_[3][3];
  ClosestPoints closest_ = {kInfinity, {1, 0, 0}, {1, 0, 0}};
};

struct Interval {
  float low, high;
};

Interval interval(float a, float b, float c) {
  const float low = a < b ? a : b, high = a < b ? b : a;
  return {c < low ? c : low, high < c ? c : high};
}

float gap(const Interval& a, const Interval& b) {
  const float above = a.low - b.high, below = b.low - a.high;
  const float most = above > below ? above : below;
  return most > 0 ? most : 0;
}

/// Corners of solids can be so far that the square overflows.
double least_squared_distance(const TriangleCorners& a, const TriangleCorners& b) {
  const float x = gap(interval(a[0].x, a[1].x, a[2].x), interval(b[0].x, b[1].x, b[2].x));
  const float y = gap(interval(a[0].y, a[1].y, a[2].y), interval(b[0].y, b[1].y, b[2].y));
  const float z = gap(interval(a[0].z, a[1].z, a[2].z), interval(b[0].z, b[1].z, b[2].z));
  const float least = (x * x + y * y + z * z) * kBoxGapShare - kBoxGapUnderflow;
  constexpr double kLeast = std::numeric_limits<double>::min();
  constexpr float kMax = std::numeric_limits<float>::max();
  return least > 0 ? double{least < kMax ? least : kMax} : kLeast;
}

}  // namespace

ClosestOnTriangle closest_on_triangle(const Vec3d& point, const TriangleCorners& triangle) {
  return closest_on(point, Face(triangle));
}

ClosestPoints closest_points(const TriangleCorners& a, const TriangleCorners& b) {
  ClosestPoints closest = ClosestOfFaces(Face(a), Face(b)).result();
  const double least = least_squared_distance(a, b);
  if (closest.squared_distance < least) closest.squared_distance = least;
  return closest;
}

ClosestPoints common_point(const TriangleCorners& a, const TriangleCorners& b) {
  const Face face_a(a), face_b(b);
  ClosestOfFaces closest(face_a, face_b);
  closest.try_piercings();
  return closest.result();
}

}  // namespace pelt::detail
