#pragma once

/// The posed characters of one frame, to be written to files and pictures.

#include <pelt/model.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pelt::tools::scene {

struct PosedInstance {
  std::string name;                     ///< "knight 0"
  std::vector<Vec3> positions;          ///< the very float32 positions that queries collide
  std::span<const Triangle> triangles;  ///< borrowed from the scene's asset
};

/// `scene` must outlive the result. Refuses what no .glb could hold.
Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const arguments::ModelArguments& arguments);

/// Smooth normals, which vertices at the same place share.
std::vector<Vec3> normals_of(const PosedInstance& instance);

}  // namespace pelt::tools::scene
