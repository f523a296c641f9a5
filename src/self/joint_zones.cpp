#include "self/joint_zones.hpp"

#include "base/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pelt::detail {
namespace {

using Body = std::uint16_t;
using TriangleNumbers = std::span<const std::uint32_t>;

constexpr double kReach = 2.5;

/// The triangles of each body.
class TrianglesOfBodies {
 public:
  explicit TrianglesOfBodies(std::span<const Body> triangle_bodies)
      : triangles_(triangle_bodies.size()) {
    for (const Body body : triangle_bodies) {
      if (begin_.size() < body + 2U) begin_.resize(body + 2U);
      ++begin_[body + 1U];
    }
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    std::vector<std::uint32_t> next = begin_;
    for (std::uint32_t t = 0; t < triangle_bodies.size(); ++t)
      triangles_[next[triangle_bodies[t]]++] = t;
  }

  /// Precondition: the body has triangles.
  TriangleNumbers operator[](Body body) const {
    return TriangleNumbers(triangles_).subspan(begin_[body], begin_[body + 1U] - begin_[body]);
  }

 private:
  std::vector<std::uint32_t> begin_, triangles_;
};

struct Ball {
  Vec3d centre;
  double radius = 0;
};

class ZoneBuilder {
 public:
  ZoneBuilder(std::span<const Vec3> positions, std::span<const Triangle> triangles,
              std::span<const Body> triangle_bodies)
      : positions_(positions), corners_(triangles), triangles_(triangle_bodies) {}

  JointZones build(const Borders& borders) {
    const std::span pairs = borders.pairs;
    const std::span vertices = borders.vertices;
    std::size_t vertex = 0;
    for (std::size_t end = 0; zones_.pair_count < pairs.size(); zones_.pair_count = end) {
      const Body body = pairs[zones_.pair_count].first;
      for (end = zones_.pair_count; end < pairs.size() && pairs[end].first == body;) ++end;
      const std::size_t first_vertex = vertex;
      while (vertex < vertices.size() && vertices[vertex].body == body) ++vertex;
      const auto above = pairs.subspan(zones_.pair_count, end - zones_.pair_count);
      if (!can_afford(body, above)) break;
      add_zone(body, above, vertices.subspan(first_vertex, vertex - first_vertex));
    }
    return std::move(zones_);
  }

 private:
  /// Limits the cost of hostile files.
  bool can_afford(Body body, std::span<const IndexPair> above) {
    constexpr std::size_t kMostTests = 64;  // per triangle of the character
    tests_ += triangles_[body].size();
    for (const IndexPair& pair : above) tests_ += triangles_[pair.second].size();
    return tests_ <= kMostTests * corners_.size();
  }

  void add_zone(Body body, std::span<const IndexPair> above, std::span<const BorderVertex> border) {
    Ball ball = ball_around(border);
    ball.radius = kReach * std::max(ball.radius, thickness(body, ball.centre));
    add_triangles_in(ball, body, body);
    for (const IndexPair& pair : above) add_triangles_in(ball, pair.second, body);
  }

  Ball ball_around(std::span<const BorderVertex> border) const {
    Vec3d lowest = at(border[0].vertex), highest = lowest;
    for (const BorderVertex& b : border) {
      const Vec3d p = at(b.vertex);
      lowest = {std::min(lowest.x, p.x), std::min(lowest.y, p.y), std::min(lowest.z, p.z)};
      highest = {std::max(highest.x, p.x), std::max(highest.y, p.y), std::max(highest.z, p.z)};
    }
    Ball ball = {0.5 * (lowest + highest)};
    for (const BorderVertex& b : border)
      ball.radius = std::max(ball.radius, squared_length(at(b.vertex) - ball.centre));
    ball.radius = std::sqrt(ball.radius);
    return ball;
  }

  /// Returns the root mean square distance of a body's triangle corners from its axis.
  double thickness(Body body, const Vec3d& centre) const {
    const TriangleNumbers own = triangles_[body];
    const double share = 1.0 / (3.0 * static_cast<double>(own.size()));
    Vec3d axis;  // from the centre to the mean of the corners
    for (const std::uint32_t t : own)
      for (const std::uint32_t vertex : corners_[t]) axis = axis + share * (at(vertex) - centre);
    const double length = squared_length(axis);
    double mean = 0;
    for (const std::uint32_t t : own)
      for (const std::uint32_t vertex : corners_[t]) {
        const Vec3d v = at(vertex) - centre;
        const double along = dot(v, axis);
        mean += share * (squared_length(v) - (length > 0 ? along * along / length : 0));
      }
    return std::sqrt(std::max(mean, 0.0));
  }

  void add_triangles_in(const Ball& ball, Body body, Body zone) {
    const auto is_outside = [&](std::uint32_t vertex) {
      return squared_length(at(vertex) - ball.centre) > ball.radius * ball.radius;
    };
    for (const std::uint32_t t : triangles_[body]) {
      const Triangle& corners = corners_[t];
      if (!std::all_of(corners.begin(), corners.end(), is_outside))
        zones_.triangles.push_back({t, zone});
    }
  }

  Vec3d at(std::uint32_t vertex) const { return Vec3d(positions_[vertex]); }

  std::span<const Vec3> positions_;    // [V]
  std::span<const Triangle> corners_;  // [T]
  TrianglesOfBodies triangles_;
  std::size_t tests_ = 0;
  JointZones zones_;
};

}  // namespace

JointZones joint_zones(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                       std::span<const std::uint16_t> triangle_bodies, const Borders& borders) {
  return ZoneBuilder(positions, triangles, triangle_bodies).build(borders);
}

}  // namespace pelt::detail
