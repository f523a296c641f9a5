#include "tools/reproduce/facing_pair.hpp"

namespace pelt::reproduce {

scenes::Scene facing_pair(const scenes::Character& character, double distance) {
  scenes::Scene scene;
  scene.name = "two of " + character.name;
  scene.characters = {character};
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

}  // namespace pelt::reproduce
