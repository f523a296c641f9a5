/// The descriptions of the pictures, without a ray tracer.

#include "evaluation/reproduce/figures.hpp"
#include "evaluation/reproduce/comparison.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/reproduce/stage.hpp"
#include "evaluation/reproduce/subdivision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelt::reproduce {
namespace {

using detail::Palette;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

scenes::Scene scene_of(std::string_view text) { return *scenes::parse_scene(text, {}); }

Palette palette_of(const scenes::Scene& scene, std::uint32_t instance, std::uint32_t frame,
                   const detail::SkinnedMesh& mesh) {
  std::vector<Matrix4> joints(mesh.joint_count);
  asset::SampleScratch scratch;
  scenes::instance_palette(scene, instance, frame, scratch, joints);
  Palette palette(mesh.joint_count, mesh.rest_extent);
  EXPECT_TRUE(palette.set(joints));
  return palette;
}

TEST(NodesOnLevel, AreThoseThatTheStatisticsCount) {
  const Specimen man = *make_specimen(scenes::kMan);
  const paper::SphereTree tree = paper::build_sphere_model(man.mesh).tree;
  const std::vector<paper::LevelStatistics> levels = level_statistics(tree);
  ASSERT_GT(levels.size(), 6u);
  for (std::uint32_t level = 1; level <= levels.size(); ++level)
    EXPECT_EQ(nodes_on_level(tree, level).size(), levels[level - 1].nodes);
  EXPECT_TRUE(nodes_on_level(tree, static_cast<std::uint32_t>(levels.size()) + 1).empty());
}

TEST(AskOnDemand, MarksAsManySpheresAsTheQueryRefitted) {
  const scenes::Scene scene = scene_of(approaching_scene());
  const Specimen man = *make_specimen(scene.characters[0].asset);
  const paper::SphereModel model = paper::build_sphere_model(man.mesh);
  for (const std::uint32_t frame : {0u, 102u, 117u}) {
    const AskedPair pair = ask_on_demand(
        man.mesh, model,
        {palette_of(scene, 0, frame, man.mesh), palette_of(scene, 1, frame, man.mesh)});
    std::size_t refitted = 0;
    for (const AskedBody& body : pair.bodies) {
      ASSERT_EQ(body.spheres.size(), model.tree.nodes.size());
      refitted +=
          static_cast<std::size_t>(std::count(body.refitted.begin(), body.refitted.end(), true));
    }
    EXPECT_EQ(refitted, pair.work.refits) << "in frame " << frame;
    EXPECT_LT(refitted, model.tree.nodes.size() / 4) << "in frame " << frame;
  }
}

TEST(LevelPicture, HasTheSpheresOfTwoLevelsTwice) {
  const Specimen creature = *make_specimen(scenes::kCreature);
  const Picture picture = level_picture(creature, walking_palette(creature, 0.3f), {});
  const std::vector<paper::LevelStatistics> levels =
      level_statistics(paper::build_sphere_model(creature.mesh).tree);
  EXPECT_EQ(count(picture.description, "texture {BlueBall}"),
            2 * (levels[3].nodes + levels[5].nodes));
  EXPECT_EQ(count(picture.description, "texture {RedBall}"), 0u);
  EXPECT_EQ(count(picture.description, "mesh2 {"), 2u);
}

TEST(RefitPicture, ShowsInBlueWhatTheQueryRefittedOnBothLevels) {
  const scenes::Scene scene = scene_of(approaching_scene());
  const Result<Picture> picture = refit_picture(scene, {});
  ASSERT_TRUE(picture) << picture.error().message;
  const Specimen man = *make_specimen(scene.characters[0].asset);
  const paper::SphereModel model = paper::build_sphere_model(man.mesh);
  const std::array<Palette, 2> palettes = {palette_of(scene, 0, kRefitFrame, man.mesh),
                                           palette_of(scene, 1, kRefitFrame, man.mesh)};
  paper::OnDemandBody a(man.mesh, model), b(man.mesh, model);
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  collide(a, palettes[0], b, palettes[1], scratch, contacts, ~0u);
  EXPECT_FALSE(contacts.empty());
  std::size_t blue = 0, red = 0;
  for (const std::uint32_t level : {5u, 6u})
    for (const std::uint32_t node : nodes_on_level(model.tree, level))
      for (const paper::OnDemandBody* body : {&a, &b}) ++(body->is_stale(node) ? red : blue);
  EXPECT_EQ(count(picture->description, "texture {BlueBall}"), blue);
  EXPECT_EQ(count(picture->description, "texture {RedBall}"), red);
  EXPECT_GT(blue, 100u);
  EXPECT_GT(red, 2 * blue);
}

TEST(PassingPicture, HasTwoCreaturesThreeTimesAndTheirContacts) {
  const Result<Picture> picture = passing_picture(scene_of(passing_through_scene()), {});
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(count(picture->description, "mesh2 {"), 6u);
  EXPECT_GT(count(picture->description, ">,0,\n"), 100u);  // glowing faces
}

TEST(DwarvesPicture, ShowsContactsFromNearAsTheyAreAndSubdivided) {
  const scenes::Character dwarf = *scenes::generate_character(scenes::kDwarf);
  scenes::Character finer = dwarf;
  finer.asset = subdivided(dwarf.asset);
  const scenes::Scene apart = facing_pair(dwarf, 0.85), meeting = facing_pair(dwarf, 0.73);
  const Result<Picture> picture = dwarves_picture(apart, meeting, facing_pair(finer, 0.73), {});
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(count(picture->description, "clipped_by"), 2u);
  EXPECT_GT(count(picture->description, ">,0,\n"), 2 * 37u) << "faces that glow";
}

TEST(DensestContact, LiesBetweenTheTwo) {
  const scenes::Character dwarf = *scenes::generate_character(scenes::kDwarf);
  const scenes::Scene meeting = facing_pair(dwarf, 0.73);
  const detail::Vec3d contact = densest_contact(*tools::picture::take_still(meeting, 0), 0.1);
  EXPECT_LT(std::abs(contact.z), 0.1);
  EXPECT_GT(contact.y, 0.2);
  const scenes::Scene apart = facing_pair(dwarf, 3);
  EXPECT_EQ(squared_length(densest_contact(*tools::picture::take_still(apart, 0), 0.1)), 0);
}

TEST(View, FindsPlacesOnThePicture) {
  const View view({{0, 1, 10}, {0, 1, 0}, 90, 2});
  EXPECT_NEAR(view.width_at({3, 2, 0}), 20, 1e-9);
  const detail::Vec3d corner = view.seen_at(2, 1, 10);
  EXPECT_NEAR(squared_length(corner - detail::Vec3d(10, 6, 0)), 0, 1e-9);
}

/// A quick run has the same scenes with fewer pixels.
TEST(Pictures, AreSmallerInAQuickRun) {
  const Specimen creature = *make_specimen(scenes::kCreature);
  const Palette palette = walking_palette(creature, 0.3f);
  Conditions quick;
  quick.is_quick = true;
  const Picture whole = level_picture(creature, palette, {});
  const Picture small = level_picture(creature, palette, quick);
  EXPECT_EQ(whole.description, small.description);
  EXPECT_NEAR(whole.width * whole.height, 3. * small.width * small.height, 4. * whole.width);
}

// The pairs for comparing methods have the stated distances.

scenes::Character small_creature() {
  auto creature = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(creature) << creature.error().message;
  return std::move(*creature);
}

/// From middle to middle.
double distance_at(const scenes::Scene& scene, std::uint32_t frame) {
  const auto z = [&](const scenes::Instance& one) {
    return one.translation[2] + one.velocity[2] * scenes::frame_time(scene, frame);
  };
  return z(scene.instances[1]) - z(scene.instances[0]);
}

TEST(FacingPair, HasEvenPhasesOfTheWalk) {
  const scenes::Character creature = small_creature();
  const scenes::Scene scene = facing_pair(creature, 0.7, 4);
  ASSERT_EQ(scene.frame_count, 4u);
  const double duration = creature.asset.find_clip("walk")->duration;
  EXPECT_NEAR(scenes::frame_time(scene, 1), duration / 4, 1e-6);
  EXPECT_DOUBLE_EQ(distance_at(scene, 0), 0.7);
  EXPECT_DOUBLE_EQ(distance_at(scene, 3), 0.7);
}

TEST(ClosingPair, ComesFromOneDistanceToTheOther) {
  const scenes::Scene scene = closing_pair(small_creature(), 0.9, 0.3, 16);
  EXPECT_NEAR(distance_at(scene, 0), 0.9, 1e-9);
  EXPECT_NEAR(distance_at(scene, 5), 0.7, 1e-9);
  EXPECT_NEAR(distance_at(scene, 15), 0.3, 1e-9);
}

TEST(HeapBytes, CountWhatIsHeld) {
  const auto before = heap_bytes();
  if (!before) GTEST_SKIP() << "this C library does not count the bytes of the heap";
  const std::vector<char> held(1 << 20, 'x');
  const auto after = heap_bytes();
  if (*after == *before) GTEST_SKIP() << "another allocator is in use";
  EXPECT_GE(*after - *before, held.size());
}

}  // namespace

}  // namespace pelt::reproduce
