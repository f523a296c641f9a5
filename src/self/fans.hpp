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
  cracked,  ///< a corner of the triangles is split into vertices with different influences
};

inline constexpr std::size_t kFanKinds = 4;

/// Largest number of triangles of a closed or open fan.
inline constexpr std::uint32_t kMaxFan = 24;

/// Largest number of triangles of a model whose clusters and triangles fit into packed numbers.
inline constexpr std::uint32_t kMaxFanTriangles = std::uint32_t{1} << 28;

class FanTriangle {
 public:
  FanTriangle() = default;
  FanTriangle(std::uint32_t place, std::uint32_t corner) : packed_(place << 2 | corner) {}

  /// Index into Tree::corners.
  std::uint32_t place() const { return packed_ >> 2; }

  /// The triangle's corner at the surface vertex.
  std::uint32_t corner() const { return packed_ & 3; }

 private:
  std::uint32_t packed_ = 0;
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

struct Fans {
  explicit Fans(const Tree& tree);

  std::vector<SurfaceCorners> corners;  // [T] by place of the triangle

  /// Fans, sorted by kind and then by number of triangles. The triangles of a closed or open fan
  /// are in counter-clockwise order. A triangle with equal corners is listed once.
  std::vector<std::uint32_t> begin;  // [F + 1] into triangles
  std::vector<FanTriangle> triangles;
  std::array<std::uint32_t, kFanKinds + 1> kind_begin{};  // into begin

  std::uint32_t count() const { return static_cast<std::uint32_t>(begin.size() - 1); }

  std::span<const FanTriangle> operator[](std::uint32_t fan) const {
    return {triangles.data() + begin[fan], begin[fan + 1] - begin[fan]};
  }

  /// The surface vertex of a fan.
  std::uint32_t vertex_of(std::uint32_t fan) const {
    const FanTriangle& first = triangles[begin[fan]];
    return corners[first.place()][first.corner()];
  }
};

}  // namespace pelt::detail
