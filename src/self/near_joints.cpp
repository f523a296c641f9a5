#include "self/near_joints.hpp"

#include "base/problem.hpp"
#include "base/vec3.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace pelt::detail {
namespace {

using Body = std::uint16_t;  // its lowest joint
using TriangleNumbers = std::span<const std::uint32_t>;

// The zones of bodies.

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

namespace {

// The bodies that are neighbours, and where they adjoin.

/// The bodies of a surface in their hierarchy.
class BodyTree {
 public:
  BodyTree(const JointBodies& bodies, std::span<const std::uint16_t> main_joints)
      : bodies_(bodies), has_triangles_(bodies.of_joints.size()) {
    for (const std::uint16_t joint : main_joints) has_triangles_[bodies.of_joints[joint]] = true;
  }

  const std::vector<std::uint16_t>& of_joints() const { return bodies_.of_joints; }

  std::vector<Body> of_triangles(std::span<const std::uint16_t> main_joints) const {
    std::vector<Body> bodies;
    bodies.reserve(main_joints.size());
    for (const std::uint16_t joint : main_joints) bodies.push_back(bodies_.of_joints[joint]);
    return bodies;
  }

  /// The next body above that moves triangles.
  std::optional<Body> above(Body body) const {
    Body next = bodies_.above[body];
    while (next != kNoJoint && !has_triangles_[next]) next = bodies_.above[next];
    return next == kNoJoint ? std::nullopt : std::optional(next);
  }

 private:
  const JointBodies& bodies_;
  std::vector<bool> has_triangles_;  // [J] by body
};

/// A body with a triangle corner at a rest position.
struct BodyAt {
  std::array<float, 3> position;
  Body body;
  std::uint32_t vertex;

  friend bool operator<(const BodyAt& a, const BodyAt& b) {
    return std::tie(a.position, a.body, a.vertex) < std::tie(b.position, b.body, b.vertex);
  }
  friend bool operator==(const BodyAt& a, const BodyAt& b) {
    return std::tie(a.position, a.body) == std::tie(b.position, b.body);
  }
};

/// Returns the bodies of all corners, ascending, each once at a position.
std::vector<BodyAt> bodies_at_corners(const JointedSurface& surface,
                                      std::span<const Body> triangle_bodies) {
  std::vector<BodyAt> corners;
  corners.reserve(3 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t vertex : surface.triangles[t]) {
      const Vec3& p = surface.rest_positions[vertex];
      corners.push_back({{p.x, p.y, p.z}, triangle_bodies[t], vertex});
    }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Adds the pairs of bodies of one position of which one is above the other.
void add_adjoining(std::span<const BodyAt> here, const BodyTree& bodies, Borders& borders) {
  constexpr int kMostSteps = 64;  // limits the cost of hostile files
  const auto is_here = [&](Body body) {
    return std::any_of(here.begin(), here.end(), [&](const BodyAt& b) { return b.body == body; });
  };
  if (here.size() < 2 || here.size() > kMostSteps) return;
  for (const BodyAt& corner : here) {
    const std::size_t count = borders.pairs.size();
    std::optional<Body> above = bodies.above(corner.body);
    for (int step = 0; above && step < kMostSteps; ++step, above = bodies.above(*above))
      if (is_here(*above)) borders.pairs.push_back({corner.body, *above});
    if (borders.pairs.size() > count) borders.vertices.push_back({corner.body, corner.vertex});
  }
}

template <typename T>
void sort_unique(std::vector<T>& elements) {
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

Borders find_borders(std::span<const BodyAt> corners, const BodyTree& bodies) {
  Borders borders;
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && corners[end].position == corners[begin].position) ++end;
    add_adjoining(corners.subspan(begin, end - begin), bodies, borders);
  }
  sort_unique(borders.pairs);
  sort_unique(borders.vertices);
  return borders;
}

/// Adds each body with itself, and with the next above unless they adjoin.
void add_hierarchy(const BodyTree& bodies, const Borders& borders, std::vector<IndexPair>& pairs) {
  for (std::size_t j = 0; j < bodies.of_joints().size(); ++j) {
    const auto body = static_cast<Body>(j);
    if (bodies.of_joints()[j] != body) continue;
    pairs.push_back({body, body});
    if (const auto above = bodies.above(body))
      if (const IndexPair pair = {body, *above};
          !std::binary_search(borders.pairs.begin(), borders.pairs.end(), pair))
        pairs.push_back(pair);
  }
}

}  // namespace

NearJoints near_joints(const JointedSurface& surface, const JointBodies& joint_bodies,
                       std::span<const Contact> at_rest) {
  const BodyTree bodies(joint_bodies, surface.main_joints);
  const std::vector<Body> triangle_bodies = bodies.of_triangles(surface.main_joints);
  const Borders borders = find_borders(bodies_at_corners(surface, triangle_bodies), bodies);

  NearJoints near = {bodies.of_joints(), {}, {}, {}};
  add_hierarchy(bodies, borders, near.joint_pairs);
  for (const Contact& contact : at_rest)
    near.joint_pairs.push_back(
        {triangle_bodies[contact.triangle_a], triangle_bodies[contact.triangle_b]});
  JointZones zones = joint_zones(surface.positions, surface.triangles, triangle_bodies, borders);
  near.zones = std::move(zones.triangles);
  const auto unzoned = borders.pairs.begin() + static_cast<std::ptrdiff_t>(zones.pair_count);
  near.joint_pairs_in_zones.assign(borders.pairs.begin(), unzoned);
  near.joint_pairs.insert(near.joint_pairs.end(), unzoned, borders.pairs.end());
  sort_unique(near.joint_pairs);
  return near;
}

namespace {

Problem check_bodies(const JointBodies& bodies, std::size_t joints) {
  const auto& [of_joints, above] = bodies;
  if (of_joints.size() != joints || above.size() != joints)
    return problem("the bodies are of %zu and %zu joints, but the model has %zu joints",
                   of_joints.size(), above.size(), joints);
  for (std::size_t j = 0; j < joints; ++j) {
    const Body body = of_joints[j], next = above[j];
    if (body > j || of_joints[body] != body)
      return problem("of_joints[%zu] is %u, expected the lowest joint of a body", j, body);
    if (next != kNoJoint && (next >= joints || of_joints[next] != next))
      return problem("above[%zu] is %u, expected a body or none", j, next);
    if (next != above[body])
      return problem("above[%zu] is %u, but above[%u], of the same body, is %u", j, next, body,
                     above[body]);
  }
  return {};
}

/// Precondition: `check_bodies` finds no problem.
Problem check_is_tree(const JointBodies& bodies) {
  constexpr std::uint8_t kUnknown = 0, kOnPath = 1, kEnds = 2;
  std::vector<std::uint8_t> state(bodies.above.size(), kUnknown);
  for (std::size_t start = 0; start < state.size(); ++start) {
    std::size_t j = start;
    for (; j != kNoJoint && state[j] == kUnknown; j = bodies.above[j]) state[j] = kOnPath;
    if (j != kNoJoint && state[j] == kOnPath) return problem("body %zu is above itself", j);
    for (j = start; j != kNoJoint && state[j] == kOnPath; j = bodies.above[j]) state[j] = kEnds;
  }
  return {};
}

Problem check_positions(std::span<const Vec3> positions, std::size_t vertices) {
  if (positions.empty()) return {};
  if (positions.size() != vertices)
    return problem("positions has %zu elements, expected %zu or none", positions.size(), vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    if (const Vec3& p = positions[v];
        !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return problem("positions[%zu] is not finite", v);
  return {};
}

Problem check_at_rest(std::span<const Contact> at_rest, std::size_t triangles) {
  for (std::size_t i = 0; i < at_rest.size(); ++i)
    if (const auto [s, t] = at_rest[i]; s >= triangles || t >= triangles)
      return problem("at_rest[%zu] refers to triangle %u, but the model has %zu triangles", i,
                     std::max(s, t), triangles);
  return {};
}

}  // namespace
}  // namespace pelt::detail

namespace pelt {

JointBodies bodies_of_parents(std::span<const std::uint16_t> joint_parents) {
  JointBodies bodies = {{}, {joint_parents.begin(), joint_parents.end()}};
  for (std::size_t j = 0; j < joint_parents.size(); ++j)
    bodies.of_joints.push_back(static_cast<std::uint16_t>(j));
  return bodies;
}

Result<NearJoints> near_joints(const SkinnedModel& model, const JointBodies& bodies,
                               std::span<const Vec3> positions, std::span<const Contact> at_rest) {
  detail::Problem found = detail::check_bodies(bodies, model.joint_count());
  if (found.empty()) found = detail::check_is_tree(bodies);
  if (found.empty()) found = detail::check_positions(positions, model.vertex_count());
  if (found.empty()) found = detail::check_at_rest(at_rest, model.triangle_count());
  if (!found.empty()) return detail::invalid_argument(std::move(found));
  const detail::SkinnedMesh mesh = detail::unpack_mesh(model.detail().tree);
  if (positions.empty()) positions = mesh.rest_positions;
  return detail::near_joints(
      {mesh.rest_positions, positions, mesh.triangles, detail::main_joints(mesh)}, bodies, at_rest);
}

}  // namespace pelt
