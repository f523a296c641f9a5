#pragma once

/// Characters of a scene, posed for queries and for drawing.

#include <pelt/pose.hpp>

#include "tools/pelt/scene/scene_glb.hpp"

#include <memory>
#include <string_view>
#include <vector>

namespace pelt::pictures {

struct Actor {
  Pose pose;
  tools::scene::PosedInstance posed;
};

/// One frame of a scene. Exits with a message if the scene is invalid, because the callers write
/// it.
class Cast {
 public:
  Cast(std::string_view scene_text, std::uint32_t frame);
  Cast(scenes::Scene scene, std::uint32_t frame);

  std::vector<Actor> actors;  ///< in the order of the instances

 private:
  std::unique_ptr<scenes::Scene> scene_;
};

}  // namespace pelt::pictures
