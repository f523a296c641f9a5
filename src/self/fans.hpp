#pragma once

/// The triangles around each surface vertex. Vertices that an exporter has split count as one
/// surface vertex if their rest positions are equal (-0 equals 0), and their displacements have the
/// same bits, whatever their influences.

#include "model/tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// How the triangles around a surface vertex are connected.
enum class FanKind : std::uint8_t {
  closed,   ///< a cycle: each triangle shares an edge with the next, the last with the first
  open,     ///< a chain
  complex,  ///< anything else, or more than kMaxFan triangles
  cracked,  ///< a corner of the triangles is split into vertices that can move apart
};

/// Whether fans of this kind can be certified (flat_fans.hpp).
inline bool can_be_flat(FanKind kind) { return kind == FanKind::closed || kind == FanKind::open; }

/// Largest number of triangles of a closed or open fan.
inline constexpr std::uint32_t kMaxFan = 24;

/// Largest number of triangles of a model whose clusters and triangles fit into packed numbers.
inline constexpr std::uint32_t kMaxFanTriangles = std::uint32_t{1} << 28;

class FanTriangle {
 public:
  FanTriangle() = default;
  FanTriangle(std::uint32_t place, std::uint32_t corner) : after_(3 * place + (corner + 1) % 3) {}

  /// Index into Tree::corners.
  std::uint32_t place() const { return after_ / 3; }

  /// The triangle's corner at the surface vertex.
  std::uint32_t corner() const { return (after_ + 2) % 3; }

  /// The next corner, counted through all triangles: three times the place, plus the corner.
  std::uint32_t after() const { return after_; }

 private:
  std::uint32_t after_ = 0;
};

/// Surface vertices of the corners of a triangle. A surface vertex is named by the lowest place of
/// its vertices in Tree::rest_positions.
using SurfaceCorners = std::array<std::uint32_t, 3>;

inline bool has_corner(const SurfaceCorners& triangle, std::uint32_t vertex) {
  return vertex == triangle[0] || vertex == triangle[1] || vertex == triangle[2];
}

inline bool share_corner(const SurfaceCorners& a, const SurfaceCorners& b) {
  return has_corner(a, b[0]) || has_corner(a, b[1]) || has_corner(a, b[2]);
}

/// Consecutive fans of one kind with the same number of triangles.
struct FanRun {
  FanKind kind;
  std::uint32_t size;            ///< triangles of each fan
  std::uint32_t first_fan, end;  ///< numbers of fans
  std::uint32_t first_triangle;  ///< into Fans::triangles

  /// Index into Fans::triangles of the first triangle of a fan of the run.
  std::uint32_t triangle_of(std::uint32_t fan) const {
    return first_triangle + (fan - first_fan) * size;
  }
};

struct Fans {
  explicit Fans(const Tree& tree);

  std::vector<SurfaceCorners> corners;  // [T] by place of the triangle

  /// Fans, sorted by kind and then by number of triangles. The triangles of a closed or open fan
  /// are in counter-clockwise order. A triangle with equal corners is listed once.
  std::vector<FanTriangle> triangles;
  std::vector<FanRun> runs;  // of all fans, ascending

  std::uint32_t count() const { return runs.empty() ? 0 : runs.back().end; }

  /// Number of closed and open fans, which come first.
  std::uint32_t flat_count() const;

  /// Cost: O(log number of runs).
  const FanRun& run_of(std::uint32_t fan) const;

  std::span<const FanTriangle> operator[](std::uint32_t fan) const {
    const FanRun& run = run_of(fan);
    return {triangles.data() + run.triangle_of(fan), run.size};
  }

  /// The surface vertex of a fan.
  std::uint32_t vertex_of(std::uint32_t fan) const {
    const FanTriangle& first = (*this)[fan][0];
    return corners[first.place()][first.corner()];
  }
};

}  // namespace pelt::detail
