#pragma once

#include <pelt/asset.hpp>
#include <pelt/math.hpp>

#include "scenes/scene.hpp"

#include <cstdint>
#include <vector>

namespace pelt::tools::scene {

/// The joint palette and the morph weights of every instance at one frame.
struct Palettes {
  std::vector<std::vector<Matrix4>> joints;
  std::vector<std::vector<float>> morphs;  ///< weights of the morph targets

  const std::vector<Matrix4>& operator[](std::size_t instance) const { return joints[instance]; }
};

/// Resizes `palettes` as needed.
void sample_palettes(const scenes::Scene& scene, std::uint32_t frame, asset::SampleScratch& scratch,
                     Palettes& palettes);
void sample_palettes(const scenes::Scene& scene, const scenes::Moment& moment,
                     asset::SampleScratch& scratch, Palettes& palettes);

/// Samples only one instance. The other instances keep their values.
void sample_instance(const scenes::Scene& scene, std::uint32_t instance,
                     const scenes::Moment& moment, asset::SampleScratch& scratch,
                     Palettes& palettes);

}  // namespace pelt::tools::scene
