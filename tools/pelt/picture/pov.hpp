#pragma once

/// Describes posed characters for the ray tracer POV-Ray, for any stage.

#include "base/vec3.hpp"
#include "tools/pelt/scene/posed_instances.hpp"

#include <array>
#include <string>
#include <vector>

namespace pelt::tools::picture {

/// POV-Ray's axes are left-handed: negates z of points and directions.
std::string pov_vector(const detail::Vec3d& v);

/// Formats a linear colour.
std::string pov_colour(const std::array<float, 3>& colour);

struct PovCamera {
  detail::Vec3d from, at;
  double angle = 40;        ///< horizontal field of view in degrees
  double aspect = 16. / 9;  ///< width over height
};

std::string pov_camera(const PovCamera& camera);

/// Shading of a mesh: smooth or flat.
enum class Shading { smooth, flat };

/// A mesh with the texture `skin`. Triangles in contact have the texture Glow, which the stage must
/// declare.
std::string pov_mesh(const scene::PosedInstance& instance, const std::vector<bool>& touching,
                     const std::string& skin, Shading shading = Shading::smooth);

}  // namespace pelt::tools::picture
