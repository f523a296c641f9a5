#pragma once

/// Embree's rays and nearest points on a posed mesh: a tree of triangles that is refitted, robust
/// traversal.

#include <pelt/distance.hpp>
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

class EmbreeMesh {
 public:
  /// `triangles` must outlive this.
  EmbreeMesh(std::span<const Triangle> triangles, std::size_t vertex_count);
  ~EmbreeMesh();

  /// Where the posed vertices are to be written before `refit`.
  std::span<Vec3> positions();

  void refit();

  /// What each ray hits first: sets `triangle` and `t` alone.
  void cast(std::span<const Ray> rays, std::span<RayHit> hits, RayCalls calls);

  /// What is nearest to each point: sets `distance` and `point.triangle` alone. By the same
  /// function of a triangle as Pelt, so that only the trees differ.
  void find_nearest(std::span<const Vec3> points, std::span<ClosestPoint> nearest);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace pelt::peers
