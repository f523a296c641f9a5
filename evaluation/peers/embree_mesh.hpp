#pragma once

/// Embree's rays and closest points on a posed mesh: a tree of triangles that is refitted, robust
/// traversal.

#include <pelt/distance.hpp>
#include <pelt/mesh.hpp>
#include <pelt/ray.hpp>

#include <memory>
#include <span>

namespace pelt::peers {

/// How rays are passed to Embree.
enum class RayCalls {
  one,     ///< rtcIntersect1
  eight,   ///< rtcIntersect8
  stream,  ///< rtcIntersect1M
};

class EmbreeMesh {
 public:
  /// `triangles` must outlive this object.
  EmbreeMesh(std::span<const Triangle> triangles, std::size_t vertex_count);
  ~EmbreeMesh();

  /// Write the posed vertices here before `refit`.
  std::span<Vec3> positions();

  void refit();

  /// Finds the first hit of each ray. Sets only `triangle` and `t`.
  void cast(std::span<const Ray> rays, std::span<RayHit> hits, RayCalls calls);

  /// Finds the triangle closest to each point. Sets only `distance` and `point.triangle`. Uses
  /// Pelt's function for a single triangle, so that only the trees differ.
  void find_closest(std::span<const Vec3> points, std::span<ClosestPoint> closest);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace pelt::peers
