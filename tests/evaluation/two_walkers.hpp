#pragma once

#include "scenes/scene.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace pelt::test {

/// Two small creatures that walk through each other.
inline scenes::Scene two_walkers() {
  scenes::Scene scene;
  scene.name = "walkers";
  Result<scenes::Character> character = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(character);
  scene.characters.push_back(std::move(*character));
  scene.fps = 12;
  scene.frame_count = 40;
  scene.instances.resize(2);
  for (const int i : {0, 1}) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {0.05 * i, 0, i == 0 ? -1.4 : 1.4};
    scene.instances[i].rotation = {0, double(i), 0, double(1 - i)};
    scene.instances[i].velocity = {0, 0, i == 0 ? 0.9 : -0.9};
  }
  return scene;
}

}  // namespace pelt::test
