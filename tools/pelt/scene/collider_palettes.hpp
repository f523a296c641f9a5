#pragma once

/// Palettes of colliders, selected from the palettes of their instances.

#include <pelt/asset.hpp>
#include <pelt/math.hpp>
#include <pelt/pose.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "skin/palette.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <cstdint>
#include <span>
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

/// Joint palette and morph weights for one pose.
struct PoseInputs {
  std::span<const Matrix4> joints;
  std::span<const float> morphs;
};

/// Returns the inputs of an instance that is not divided into parts.
inline PoseInputs inputs_of_instance(const Palettes& palettes, std::uint32_t instance) {
  return {palettes.joints[instance], palettes.morphs[instance]};
}

/// Selects the inputs of colliders. Each thread needs its own selection.
class InputSelection {
 public:
  /// Valid until the next call. Cost: O(1) for a whole instance; for a part, linear in the joints
  /// and morph targets that it follows.
  PoseInputs select(const Palettes& palettes, const Collider& collider);

 private:
  std::vector<Matrix4> joints_;
  std::vector<float> morphs_;
};

/// Sets the pose of `poser`, which is a Pose; or, with the number of an instance or a body as
/// `number`, a Crowd or a methods::Method.
template <typename Poser, typename... Number>
Result<void> set_pose(const PoseInputs& inputs, Poser& poser, Number... number) {
  if (!inputs.morphs.empty()) {
    if (Result<void> taken = poser.set_morph_weights(number..., inputs.morphs); !taken)
      return taken;
  }
  return poser.set_palette(number..., inputs.joints);
}

/// Poses all vertices; replaces `positions`.
Result<void> pose_vertices(const PoseInputs& inputs, Pose& pose, std::vector<Vec3>& positions);

/// Prefixes the message of an error with the instance.
Error in_instance(std::uint32_t instance, const Error& error);

/// Validates the inputs of instances that are divided into parts as those of whole instances, so
/// that messages number joints and morph targets as the asset does, and so that also those are
/// checked that no part follows.
class PartedInstances {
 public:
  explicit PartedInstances(std::span<const Collider> colliders);

  /// The message of an error names the instance. If there is no error, all parts accept what
  /// InputSelection selects for them.
  Result<void> check(const Palettes& palettes);

 private:
  struct Parted {
    std::uint32_t instance;
    detail::Palette palette;
  };

  std::vector<Parted> parted_;
};

}  // namespace pelt::tools::scene
