#pragma once

/// A crowd of any size of one character that walks on a plain, for measuring.

#include "scenes/scene.hpp"

#include <pelt/model.hpp>

#include <cstdint>
#include <vector>

namespace pelt::programs {

/// A clip in `count` phases, as palettes of an instance at the origin.
class WalkPhases {
 public:
  static constexpr std::uint32_t kCount = 64;

  explicit WalkPhases(const asset::Asset& asset);

  std::uint32_t joint_count() const { return joint_count_; }
  std::span<const Matrix4> operator[](std::uint32_t phase) const {
    return std::span(palettes_).subspan(std::size_t{phase} * joint_count_, joint_count_);
  }

  /// Six of the palettes, for build_model.
  std::vector<Matrix4> samples() const;

 private:
  std::uint32_t joint_count_;
  std::vector<Matrix4> palettes_;
};

/// Instances in rows, with as many rows as a row has walkers. They walk on the spot in different
/// directions, one phase later in each frame, so the crowd stays as sparse as at the start.
class WalkingCrowd {
 public:
  /// `metre` is in units of the character. `phases` must outlive the crowd.
  WalkingCrowd(const WalkPhases& phases, std::uint32_t count, double metre);

  std::uint32_t count() const { return static_cast<std::uint32_t>(walkers_.size()); }

  /// The palettes of all instances, concatenated.
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
