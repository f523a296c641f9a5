#pragma once

/// Which vertices of a mesh are near each other along its edges.

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

#include "bindings/python/engine/run_frames.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::python {

/// For each pair of vertices, whether a path along edges connects them that is shorter than a
/// limit. V^2 / 8 bytes for V vertices.
class NearAlongEdges {
 public:
  /// Runs the algorithm of Dijkstra from each vertex, on several threads. The caller has the
  /// interpreter lock. Precondition: all indices are less than the number of positions.
  NearAlongEdges(std::span<const Vec3> positions, std::span<const Triangle> faces, double limit,
                 const Run& run);

  std::size_t vertex_count() const { return vertex_count_; }

  /// A vertex is near itself.
  bool near(std::size_t a, std::size_t b) const {
    return (bits_[a * row_ + b / 64] >> (b % 64) & 1) != 0;
  }

 private:
  std::size_t vertex_count_, row_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace pelt::python
