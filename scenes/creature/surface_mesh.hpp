#pragma once

#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// The connectivity of a closed triangle mesh under edge collapses and flips.
///
/// Triangle t has the half-edges 3t, 3t + 1, 3t + 2, each from its origin to the origin of the next
/// one. The twin of a half-edge has the opposite direction in the adjacent triangle. Collapsed
/// vertices and triangles remain in the arrays as dead elements, which `live_triangles` skips.
class SurfaceMesh {
 public:
  /// Precondition: the triangles form a consistently oriented, closed 2-manifold.
  SurfaceMesh(std::span<const Triangle> triangles, std::uint32_t vertex_count);

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(outgoing_.size()); }
  std::uint32_t half_edge_count() const { return static_cast<std::uint32_t>(origin_.size()); }
  std::uint32_t triangle_count() const { return live_triangles_; }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }
  std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
  std::uint32_t target(std::uint32_t h) const { return origin_[next(h)]; }
  bool is_live_half_edge(std::uint32_t h) const { return origin_[h] != kDead; }
  bool is_live_vertex(std::uint32_t v) const { return outgoing_[v] != kDead; }

  /// Calls `visit(half_edge)` for each half-edge that leaves the vertex, in order around it.
  template <typename Visit>
  void for_each_outgoing(std::uint32_t vertex, Visit visit) const {
    const std::uint32_t first = outgoing_[vertex];
    std::uint32_t h = first;
    do {
      visit(h);
      h = twin_[previous(h)];
    } while (h != first);
  }

  std::uint32_t valence(std::uint32_t vertex) const;

  /// Whether collapsing the edge leaves a closed 2-manifold: the only common neighbours of its ends
  /// are the two vertices opposite the edge, and each of these keeps at least three neighbours.
  bool can_collapse(std::uint32_t h) const;

  /// Merges the half-edge's target into its origin; the target and two triangles become dead.
  void collapse(std::uint32_t h);

  /// Whether the other diagonal of the two triangles at the edge is not yet an edge, and the ends
  /// keep at least three neighbours.
  bool can_flip(std::uint32_t h) const;

  /// Replaces the edge by the other diagonal of its two triangles.
  void flip(std::uint32_t h);

  std::vector<Triangle> live_triangles() const;

 private:
  static constexpr std::uint32_t kDead = 0xFFFFFFFF;

  bool are_neighbours(std::uint32_t a, std::uint32_t b) const;
  void make_twins(std::uint32_t h, std::uint32_t g);
  void kill_triangle(std::uint32_t h);

  std::vector<std::uint32_t> origin_;    // [half-edges]
  std::vector<std::uint32_t> twin_;      // [half-edges]
  std::vector<std::uint32_t> outgoing_;  // [vertices] one of the half-edges that leave it
  std::uint32_t live_triangles_ = 0;
};

}  // namespace pelt::scenes
