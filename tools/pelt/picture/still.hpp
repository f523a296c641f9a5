#pragma once

/// A picture of one frame of a scene, as a description for POV-Ray.

#include "base/vec3.hpp"
#include "tools/pelt/scene/scene_glb.hpp"

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

struct StillFrame {
  std::vector<scene::PosedInstance> instances;
  std::vector<std::vector<bool>> touching;  ///< by instance and triangle
};

/// `scene` must outlive the result.
Result<StillFrame> take_still(const scenes::Scene& scene, std::uint32_t frame);

/// Smooth skins on a dark ground in soft light, with the triangles in contact glowing. The camera
/// looks along -x at the middle of the instances. Precondition: there is an instance.
std::string describe_still(const StillFrame& still);

}  // namespace pelt::tools::picture
