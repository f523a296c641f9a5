#pragma once

#include "evaluation/peers/candidates.hpp"

#include <embree3/rtcore.h>

namespace pelt::peers {

/// The triangles of a body as Embree's user geometry, in a scene of its own.
///
/// A geometry of quality REFIT is refitted only in a scene of quality LOW; in any other scene it is
/// silently built again, which takes 30 times as long.
class EmbreeBody {
 public:
  EmbreeBody(RTCDevice device, std::span<const Triangle> triangles, std::span<const Vec3> rest);
  EmbreeBody(const EmbreeBody&) = delete;
  EmbreeBody& operator=(const EmbreeBody&) = delete;
  ~EmbreeBody();

  void update(std::span<const Vec3> positions);

  const PosedBody& mesh() const { return mesh_; }
  RTCScene scene() const { return scene_; }

 private:
  void commit();

  PosedBody mesh_;
  RTCScene scene_;
  RTCGeometry geometry_;
};

}  // namespace pelt::peers
