#include "evaluation/reproduce/facing_pair.hpp"

namespace pelt::reproduce {

scenes::Scene facing_pair(const scenes::Character& character, double distance,
                          std::uint32_t phases) {
  scenes::Scene scene;
  scene.name = "two of " + character.name;
  scene.characters = {character};
  scene.frame_count = phases;
  if (const asset::Clip* walk = character.asset.find_clip("walk"); walk && walk->duration > 0)
    scene.fps = phases / static_cast<double>(walk->duration);
  scenes::Instance left, right;
  left.clip = right.clip = "walk";
  left.start = 0.2;
  right.start = 0.65;
  left.translation = {0, 0, -distance / 2};
  right.translation = {0, 0, distance / 2};
  right.rotation = {0, 1, 0, 0};
  scene.instances = {left, right};
  return scene;
}

scenes::Scene closing_pair(const scenes::Character& character, double from, double to,
                           std::uint32_t frames) {
  scenes::Scene scene = facing_pair(character, from, frames);
  const double seconds = (frames - 1) / scene.fps;
  scene.instances[0].velocity = {0, 0, (from - to) / 2 / seconds};
  scene.instances[1].velocity = {0, 0, (to - from) / 2 / seconds};
  return scene;
}

}  // namespace pelt::reproduce
