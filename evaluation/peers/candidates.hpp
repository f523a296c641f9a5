#pragma once

/// Pelt's narrow phase for two bodies, and for a body against itself, for libraries that expose
/// their candidates.

#include <pelt/collide.hpp>

#include "geometry/triangle_pair.hpp"
#include "self/neighbours.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <vector>

namespace pelt::peers {

/// A body at its last update.
struct PosedBody {
  PosedBody(std::span<const Triangle> its_triangles, std::span<const Vec3> rest)
      : triangles(its_triangles), rest_positions(rest.begin(), rest.end()) {}
  PosedBody(const PosedBody&) = delete;
  PosedBody& operator=(const PosedBody&) = delete;

  detail::TriangleCorners corners(std::uint32_t triangle) const {
    const Triangle& v = triangles[triangle];
    return {positions[v[0]], positions[v[1]], positions[v[2]]};
  }

  std::span<const Triangle> triangles;
  std::vector<Vec3> rest_positions;  ///< until the first update
  std::span<const Vec3> positions = rest_positions;
};

/// Tests the candidates of one query and appends the pairs that intersect, up to a limit.
class Candidates {
 public:
  Candidates(const PosedBody& a, const PosedBody& b, std::vector<Contact>& contacts,
             std::uint32_t max_contacts)
      : a_(a), b_(b), contacts_(contacts), wanted_(max_contacts) {
    work_.cut_short = wanted_ == 0;
  }

  /// False once the limit is reached; other candidates are ignored.
  bool wants_more() const { return wanted_ > 0; }

  void add(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    if (!wants_more()) return;
    ++work_.triangle_pairs;
    if (detail::triangles_intersect(a_.corners(triangle_a), b_.corners(triangle_b)))
      append(triangle_a, triangle_b);
  }

  const QueryStats& work() const { return work_; }

 private:
  void append(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    contacts_.push_back({triangle_a, triangle_b});
    work_.cut_short = --wanted_ == 0;
  }

  const PosedBody &a_, &b_;
  std::vector<Contact>& contacts_;
  std::uint32_t wanted_;
  QueryStats work_;
};

/// Returns for each vertex the lowest vertex at the same rest position.
inline std::vector<std::uint32_t> surface_vertices(std::span<const Vec3> rest) {
  std::map<std::tuple<float, float, float>, std::uint32_t> lowest;
  std::vector<std::uint32_t> surface;
  for (std::uint32_t v = 0; v < rest.size(); ++v)
    surface.push_back(lowest.emplace(std::tuple(rest[v].x, rest[v].y, rest[v].z), v).first->second);
  return surface;
}

/// The surface vertices of the triangles of a body.
class Neighbours {
 public:
  Neighbours(std::span<const Triangle> triangles, std::span<const Vec3> rest) {
    const std::vector<std::uint32_t> surface = surface_vertices(rest);
    for (const Triangle& t : triangles)
      corners_.push_back({surface[t[0]], surface[t[1]], surface[t[2]]});
  }

  const std::array<std::uint32_t, 3>& operator[](std::uint32_t triangle) const {
    return corners_[triangle];
  }

  /// Whether two triangles share a surface vertex.
  bool are(std::uint32_t s, std::uint32_t t) const {
    const auto &a = corners_[s], &b = corners_[t];
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

 private:
  std::vector<std::array<std::uint32_t, 3>> corners_;
};

/// The treatment of pairs of triangles that share a surface vertex, and therefore always touch.
enum class OfNeighbours {
  decided,   ///< by the rule of self_collide
  left_out,  ///< their contacts are missing
};

/// Tests the candidates of one query of a body against itself and appends the pairs that intersect,
/// up to a limit. `Apart` decides whether two triangles that share nothing intersect.
template <typename Apart>
class SelfCandidates {
 public:
  SelfCandidates(const PosedBody& mesh, const Neighbours& neighbours, OfNeighbours of_neighbours,
                 Apart apart, std::vector<Contact>& contacts, std::uint32_t max_contacts)
      : mesh_(mesh),
        neighbours_(neighbours),
        of_neighbours_(of_neighbours),
        apart_(apart),
        contacts_(contacts),
        wanted_(max_contacts) {
    work_.cut_short = wanted_ == 0;
  }

  /// False once the limit is reached; other candidates are ignored.
  bool wants_more() const { return wanted_ > 0; }

  /// Ignores a triangle with itself.
  void add(std::uint32_t s, std::uint32_t t) {
    if (s == t || !wants_more()) return;
    const bool are_neighbours = neighbours_.are(s, t);
    if (are_neighbours && of_neighbours_ == OfNeighbours::left_out) return;
    ++work_.triangle_pairs;
    if (!(are_neighbours ? surface_triangles_intersect(triangle(s), triangle(t)) : apart_(s, t)))
      return;
    contacts_.push_back({std::min(s, t), std::max(s, t)});
    work_.cut_short = --wanted_ == 0;
  }

  const QueryStats& work() const { return work_; }

 private:
  detail::SurfaceTriangle triangle(std::uint32_t t) const {
    return {mesh_.corners(t), neighbours_[t]};
  }

  const PosedBody& mesh_;
  const Neighbours& neighbours_;
  OfNeighbours of_neighbours_;
  Apart apart_;
  std::vector<Contact>& contacts_;
  std::uint32_t wanted_;
  QueryStats work_;
};

/// Pelt's predicate for triangles that share nothing.
struct ApartByPelt {
  const PosedBody& mesh;

  bool operator()(std::uint32_t s, std::uint32_t t) const {
    return detail::triangles_intersect(mesh.corners(s), mesh.corners(t));
  }
};

}  // namespace pelt::peers
