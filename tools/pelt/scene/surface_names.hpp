#pragma once

/// Names of points of surfaces.

#include <pelt/distance.hpp>

#include "tools/pelt/scene/colliders.hpp"

#include <string>

namespace pelt::tools::scene {

/// Description of a point of a collider's surface.
struct NamedPoint {
  std::uint32_t triangle = 0;  ///< its number in the whole model
  std::string part, joint;
};

NamedPoint name_point(const scenes::Scene& scene, const Collider& collider,
                      const SurfacePoint& point);

/// "knight 0 Knight_Helmet (head, triangle 12)"
std::string place_words(const scenes::Scene& scene, const Collider& collider,
                        const SurfacePoint& point);

}  // namespace pelt::tools::scene
