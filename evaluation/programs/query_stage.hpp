#pragma once

/// Frames of two instances of a character in which each query has something to find.

#include "scenes/scene.hpp"

#include <pelt/distance.hpp>
#include <pelt/height_field.hpp>

#include <cstdint>
#include <vector>

namespace pelt::programs {

using JointPalette = std::vector<Matrix4>;

struct QueryFrame {
  JointPalette a, touching, near, far;  ///< the first instance; the second
  std::vector<Vec3> points;             ///< around the first
};

class QueryStage {
 public:
  /// Frames along the character's first clip. A character is 1.75 metres high in its default pose.
  QueryStage(const asset::Asset& asset, const SkinnedModel& model, std::uint32_t frames,
             std::uint32_t points);

  double metre() const { return metre_; }
  const std::vector<QueryFrame>& frames() const { return frames_; }

  /// Hills around the character with a vertex every tenth of a metre; its feet are 3 cm in the
  /// ground.
  HeightField hills(std::uint32_t side) const;

 private:
  double metre_ = 1;
  Vec3 foot_;
  std::vector<QueryFrame> frames_;
};

/// All triangles of a field, with the same numbers, as a mesh with one joint. Precondition: the
/// field has no holes.
SkinnedModel as_static_mesh(const HeightField& field);

}  // namespace pelt::programs
