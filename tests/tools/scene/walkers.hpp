#pragma once

/// Scenes of creatures, with their colliders and palettes.

#include "scenes/creature.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <gtest/gtest.h>

namespace pelt::test {

/// Two small creatures that walk through each other.
inline scenes::Scene walkers() {
  scenes::Scene scene;
  scene.name = "walkers";
  for (const scenes::CreatureOptions& options :
       {scenes::CreatureOptions{1000, 24, 1}, scenes::CreatureOptions{1200, 45, 2}}) {
    Result<scenes::Character> character = scenes::generate_character(options);
    EXPECT_TRUE(character);
    scene.characters.push_back(std::move(*character));
  }
  scene.fps = 6;
  scene.frame_count = 12;
  scene.instances.resize(2);
  scene.instances[0].clip = scene.instances[1].clip = "walk";
  scene.instances[0].translation = {-0.1, 0, -0.9};
  scene.instances[0].velocity = {0, 0, 0.9};
  scene.instances[1].character = 1;
  scene.instances[1].translation = {0.1, 0, 0.9};
  scene.instances[1].rotation = {0, 1, 0, 0};
  scene.instances[1].velocity = {0, 0, -0.9};
  return scene;
}

/// Two faces that talk inside each other.
inline scenes::Scene talkers(std::uint32_t triangles) {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::FaceOptions{triangles, 1}));
  scene.fps = 6;
  scene.frame_count = 12;
  scene.instances.resize(2);
  scene.instances[0].clip = scene.instances[1].clip = "talk";
  scene.instances[1].translation = {0.05, 0.02, 0.01};
  scene.instances[1].start = 0.4;
  return scene;
}

inline std::vector<tools::scene::Collider> colliders_of(
    const scenes::Scene& scene,
    tools::scene::Granularity granularity = tools::scene::Granularity::instance) {
  auto colliders = tools::scene::make_colliders(scene, granularity, {});
  EXPECT_TRUE(colliders) << colliders.error().message;
  return std::move(*colliders);
}

inline tools::scene::Palettes palettes_of(const scenes::Scene& scene, std::uint32_t frame) {
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(scene, frame, scratch, palettes);
  return palettes;
}

}  // namespace pelt::test
