#pragma once

/// Any number of instances of one character that walk about on a plain, for measuring crowds.

#include "scenes/scene.hpp"

#include <pelt/model.hpp>

#include <cstdint>
#include <vector>

namespace pelt::programs {

/// The clip in so many phases, as palettes of an instance at the origin.
class WalkPhases {
 public:
  static constexpr std::uint32_t kCount = 64;

  explicit WalkPhases(const asset::Asset& asset);

  std::uint32_t joint_count() const { return joint_count_; }
  std::span<const Matrix4> operator[](std::uint32_t phase) const {
    return std::span(palettes_).subspan(std::size_t{phase} * joint_count_, joint_count_);
  }

  /// Half a dozen of them, for build_model.
  std::vector<Matrix4> samples() const;

 private:
  std::uint32_t joint_count_;
  std::vector<Matrix4> palettes_;
};

/// Instances in as many rows as a row has walkers, that walk on the spot into directions of their
/// own, a phase further in each frame: so the crowd stays as sparse as it begins.
class WalkingCrowd {
 public:
  /// `metre` in units of the character. `phases` must outlive the crowd.
  WalkingCrowd(const WalkPhases& phases, std::uint32_t count, double metre);

  std::uint32_t count() const { return static_cast<std::uint32_t>(walkers_.size()); }

  /// The palettes of all instances, one after the other.
  void pose(std::uint32_t frame, std::vector<Matrix4>& palettes) const;

 private:
  struct Walker {
    float x, z;
    float forward_x, forward_z;  // a unit vector
    std::uint32_t phase;
  };

  const WalkPhases& phases_;
  std::vector<Walker> walkers_;
};

}  // namespace pelt::programs
