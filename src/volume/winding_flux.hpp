#pragma once

#include <pelt/pose.hpp>

#include "exact/exact_number.hpp"
#include "geometry/generic_ray.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <span>

namespace pelt::detail {

/// Returns the flux of 1 through all triangles. Precondition: all nodes are open.
Rounded surface_flux(const PosedTree& posed, const Vec3& origin);

/// The surface of another body, as seen from the vertices of one body.
struct OtherSurface {
  pelt::Pose& pose;

  /// The infinitesimal motion of the vertices relative to the surface.
  const GenericDirection& motion;

  /// By how much its winding number changes along triangles of the body, ascending by place.
  std::span<const WindingTurns> turns;
};

/// Returns the flux through all triangles of a body, as if on each triangle the winding number of
/// the other surface were the same as at corner 0. Precondition: there are tables of opened nodes.
Rounded winding_flux(const PosedTree& body, const OtherSurface& other, const Vec3& origin,
                     pelt::Scratch& scratch, QueryStats& work);

}  // namespace pelt::detail
