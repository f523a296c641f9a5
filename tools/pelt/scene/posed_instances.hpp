#pragma once

/// The posed characters of one frame, for writing to files and pictures.

#include <pelt/model.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pelt::tools::scene {

struct PosedInstance {
  std::string name;                     ///< "knight 0"
  std::vector<Vec3> positions;          ///< exactly the positions that queries use
  std::span<const Triangle> triangles;  ///< borrowed from the scene's asset
};

/// `scene` must outlive the result. Returns an error for instances that are too large for a .glb
/// file.
Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const arguments::ModelArguments& arguments);

/// Smooth normals; vertices at the same position share them.
std::vector<Vec3> normals_of(const PosedInstance& instance);

}  // namespace pelt::tools::scene
