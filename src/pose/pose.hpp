#pragma once

#include <pelt/pose.hpp>

#include "model/model.hpp"
#include "pose/palette.hpp"

namespace pelt::detail {

struct Pose {
  SkinnedModel model;
  Palette palette;
  EnginePoseHandle engine_pose;

  EngineSide side() { return {model.detail().mesh, palette, *model.detail().engine, *engine_pose}; }
};

}  // namespace pelt::detail
