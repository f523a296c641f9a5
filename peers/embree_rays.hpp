#pragma once

/// Embree's rays on a posed mesh: a tree of triangles that is refitted, robust traversal.

#include <pelt/mesh.hpp>
#include <pelt/ray.hpp>

#include <memory>
#include <span>

namespace pelt::peers {

/// How rays are handed over.
enum class RayCalls {
  one,     ///< rtcIntersect1
  eight,   ///< rtcIntersect8
  stream,  ///< rtcIntersect1M
};

class EmbreeRays {
 public:
  /// `triangles` must outlive this.
  EmbreeRays(std::span<const Triangle> triangles, std::size_t vertex_count);
  ~EmbreeRays();

  /// Where the posed vertices are to be written before `refit`.
  std::span<Vec3> positions();

  void refit();

  /// What each ray hits first: sets `triangle` and `t` alone.
  void cast(std::span<const Ray> rays, std::span<RayHit> hits, RayCalls calls);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace pelt::peers
