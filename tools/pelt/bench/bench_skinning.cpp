#include "tools/pelt/bench/bench_skinning.hpp"

#include <pelt/pose.hpp>

#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

namespace pelt::tools::bench {
namespace {

/// An instance and the memory for its posed vertices.
struct Skinned {
  explicit Skinned(const scene::Collider& collider)
      : instance(collider.instance),
        pose(collider.model),
        positions(collider.model.vertex_count()) {}

  std::uint32_t instance;
  Pose pose;
  std::vector<Vec3> positions;
};

double time_us(std::vector<Skinned>& all) {
  Stopwatch watch;
  for (Skinned& skinned : all) posed_vertices(skinned.pose, skinned.positions);
  watch.stop();
  return watch.microseconds();
}

}  // namespace

Result<Skinning> measure_skinning(const Subject& subject, std::uint32_t repetitions) {
  std::vector<Skinned> all(subject.colliders.begin(), subject.colliders.end());
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  std::vector<double> frames;
  for (const std::uint32_t frame : subject.frames) {
    scene::sample_palettes(subject.scene, frame, scratch, palettes);
    for (Skinned& skinned : all) {
      const auto morphed = skinned.pose.set_morph_weights(palettes.morphs[skinned.instance]);
      if (!morphed) return morphed.error();
      const auto posed = skinned.pose.set_palette(palettes[skinned.instance]);
      if (!posed) return posed.error();
    }
    std::vector<double> times;
    for (std::uint32_t r = 0; r < repetitions; ++r) times.push_back(time_us(all));
    frames.push_back(output::median(times));
  }
  Skinning skinning;
  skinning.mean_us = output::mean(frames);
  for (const Skinned& skinned : all) skinning.vertices += skinned.positions.size();
  return skinning;
}

}  // namespace pelt::tools::bench
