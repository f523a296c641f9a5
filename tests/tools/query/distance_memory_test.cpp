/// A program of its own, because it replaces operator new.

#include "support/allocation_count.hpp"
#include "tools/pelt/query/distance_query.hpp"
#include "tools/scene/walkers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <streambuf>

namespace pelt::tools::query {
namespace {

/// Counts the characters that are written, and stores none.
class Counter : public std::streambuf {
 public:
  std::size_t count = 0;

 protected:
  int_type overflow(int_type c) override { return ++count, traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize size) override {
    return count += static_cast<std::size_t>(size), size;
  }
};

scenes::Scene row_of_creatures(std::uint32_t count) {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::CreatureOptions{1000, 24, 1}));
  scene.instances.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {5.0 * i, 0, 0};
  }
  return scene;
}

TEST(DistanceMemory, DoesNotGrowWithTheNumberOfPairs) {
  constexpr std::uint32_t kInstances = 300, kPairs = kInstances * (kInstances - 1) / 2;
  const scenes::Scene scene = row_of_creatures(kInstances);
  const auto colliders = test::colliders_of(scene);
  const scene::StagedScene staged(scene, colliders);
  scene::ScenePoses poses(colliders);
  DistanceQuery query(staged, {}, DistanceQuery::Lists::all, 256);
  Counter counter;
  std::ostream out(&counter);
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  test::reset_largest_allocation();
  for (const std::uint32_t frame : {0u, 10u}) {
    scene::sample_palettes(scene, frame, scratch, palettes);
    ASSERT_TRUE(poses.set_palettes(palettes));
    query.ask(poses.poses());
    query.keep(frame);
    scene::JsonLine line(out);
    query.write_frame(line);
    query.write_totals(line);
    line.end();
  }
  ASSERT_TRUE(query.status());
  EXPECT_GT(counter.count, std::size_t{4} * kPairs * 100) << "two lists of pairs for each frame";
  EXPECT_LT(test::largest_allocation(), kPairs * sizeof(PairDistance) / 8);
}

}  // namespace
}  // namespace pelt::tools::query
