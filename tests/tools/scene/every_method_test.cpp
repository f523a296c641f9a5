/// Every method finds the same contacts, and at least one: of generated characters, and of real
/// ones if they are available.

#include "tools/scene/every_method.hpp"
#include "tools/scene/walkers.hpp"

#include <filesystem>

namespace pelt::test {
namespace {

TEST(Walkers, CollideAlikeByEveryMethod) {
  const scenes::Scene scene = walkers();
  const std::uint32_t in_contact = in_contact_by_every_method(scene, 0, scene.frame_count);
  EXPECT_GE(in_contact, 4u);
  EXPECT_LT(in_contact, scene.frame_count);
}

struct SharedScene {
  const char* name;
  std::uint32_t frame;  ///< in contact
};

class SharedScenes : public ::testing::TestWithParam<SharedScene> {};

TEST_P(SharedScenes, HaveTheSameAnswerByEveryMethod) {
  const std::string path = std::string(PELT_SHARED_DIR) + "/scenes/" + GetParam().name;
  if (!std::filesystem::exists(PELT_SHARED_DIR)) GTEST_SKIP() << PELT_SHARED_DIR << " is not there";
  const Result<scenes::Scene> scene = scenes::load_scene(path);
  ASSERT_TRUE(scene) << scene.error().message;
  const std::uint32_t frame = GetParam().frame;
  EXPECT_EQ(in_contact_by_every_method(*scene, frame, frame + 1), 1u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedScenes,
                         ::testing::Values(SharedScene{"two_walkers.json", 117},
                                           SharedScene{"walk_through.json", 50},
                                           SharedScene{"duel.json", 12},
                                           SharedScene{"zoo.json", 20},
                                           SharedScene{"crowd50.json", 20}),
                         [](const auto& scene) {
                           const std::string name = scene.param.name;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt::test
