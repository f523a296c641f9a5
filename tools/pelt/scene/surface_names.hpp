#pragma once

/// Names of points of surfaces.

#include <pelt/distance.hpp>

#include "tools/pelt/scene/staged_scene.hpp"

#include <string>

namespace pelt::tools::scene {

/// Description of a point of a collider's surface.
struct NamedPoint {
  std::uint32_t triangle = 0;  ///< its number in the whole model
  std::string part, joint;
};

NamedPoint name_point(const StagedScene& staged, const Collider& collider,
                      const SurfacePoint& point);

/// "knight 0 Knight_Helmet (head, triangle 12)"
std::string place_words(const StagedScene& staged, const Collider& collider,
                        const SurfacePoint& point);

}  // namespace pelt::tools::scene
