#include "tools/pelt/arguments/scene_arguments.hpp"

#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/test_scenes.hpp"

#include <sstream>

namespace pelt::test {
namespace {

class SceneArguments : public ::testing::Test {
 protected:
  SceneArguments() {
    strip_ = write_strip(folder_, "strip.glb");
    write_limbs(folder_);
  }

  std::string limb() const { return folder_ / "one.glb"; }

  std::string refusal(const tools::arguments::SceneArguments& arguments) {
    const auto scene = tools::arguments::open_scene(arguments);
    return scene ? "" : scene.error().message;
  }

  std::vector<std::string> notes(const tools::arguments::SceneArguments& arguments,
                                 const std::string& frames = "") {
    auto scene = tools::arguments::open_scene(arguments);
    EXPECT_TRUE(scene) << scene.error().message;
    EXPECT_TRUE(tools::arguments::choose_frames(frames, arguments, *scene));
    return scene->notes;
  }

  TestFolder folder_;
  std::string strip_;
};

TEST_F(SceneArguments, NoteModelsThatStandInTheDefaultPoseAndInOnePlace) {
  tools::arguments::SceneArguments arguments;
  arguments.inputs = {strip_, limb()};
  const std::vector<std::string> both = notes(arguments);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0],
            "2 models stand in the default pose: select a clip for each model with --clip; pelt "
            "info lists the clips (-: default pose)");
  EXPECT_EQ(both[1], "all models are in one place: place each of them with --at X,Y,Z");
  arguments.positions = {"0,0,0"};
  arguments.clips = {"bend"};
  EXPECT_EQ(notes(arguments).size(), 1u);
  arguments.clips = {"bend", "-"};
  EXPECT_TRUE(notes(arguments).empty());
}

TEST_F(SceneArguments, NoteThatAllFramesAreAlike) {
  tools::arguments::SceneArguments arguments;
  arguments.inputs = {strip_};
  arguments.clips = {"-"};
  EXPECT_TRUE(notes(arguments, "3:4").empty());
  const std::vector<std::string> alike = notes(arguments, "0:10");
  ASSERT_EQ(alike.size(), 1u);
  EXPECT_EQ(alike[0].find("nothing moves, so all frames are the same"), 0u);
  arguments.clips = {"bend"};
  EXPECT_TRUE(notes(arguments, "0:10").empty());
}

TEST_F(SceneArguments, NoteFramesThatRepeatTheClips) {
  tools::arguments::SceneArguments arguments;
  arguments.inputs = {strip_};
  arguments.clips = {"bend"};
  EXPECT_TRUE(notes(arguments, "0:30").empty());
  EXPECT_EQ(notes(arguments, "29:31"),
            std::vector<std::string>{"frames from 30 on repeat the clip, which has 30 frames"});
  arguments.inputs = {strip_, limb()};
  arguments.positions = {"0,0,0"};
  arguments.clips = {"bend", "-"};
  EXPECT_EQ(notes(arguments, "40:41"),
            std::vector<std::string>{
                "frames from 30 on repeat the clips, the longest of which has 30 frames"});
}

TEST_F(SceneArguments, SayInTheSummaryWhatTheyNote) {
  scenes::Scene scene;
  scene.notes = {"one thing", "another"};
  std::ostringstream words;
  tools::scene::print_scene({scene, {}}, words);
  EXPECT_TRUE(contains(words.str(), "\nnote       one thing\nnote       another\n"));
}

TEST_F(SceneArguments, LeaveOutWhatOneOfSeveralModelsHas) {
  tools::arguments::SceneArguments arguments;
  arguments.inputs = {strip_, limb()};
  for (const char* name : {"fan", "strip/fan"}) {
    arguments.models.exclude = {name};
    const auto scene = tools::arguments::open_scene(arguments);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->characters[0].asset.parts.size(), 1u);
    EXPECT_EQ(scene->characters[1].asset.parts.size(), 1u);
  }
  arguments.models.exclude = {"one/fan"};
  EXPECT_EQ(refusal(arguments).find("--exclude: no node to exclude is named \"one/fan\""), 0u);
}

TEST_F(SceneArguments, SayWhatMayBeGivenForAFileOfAnotherKind) {
  write_text(folder_ / "answer.jsonl", "{}\n{}\n");
  tools::arguments::SceneArguments arguments;
  arguments.inputs = {folder_ / "answer.jsonl"};
  EXPECT_EQ(
      refusal(arguments),
      arguments.inputs[0] + ": is not a model: give a scene, .json, or models, .glb or .gltf");
  write_text(folder_ / "empty.glb", "");
  arguments.inputs = {folder_ / "empty.glb"};
  EXPECT_EQ(refusal(arguments),
            arguments.inputs[0] + ": the file is empty: copy or export it again");
  const auto scene = tools::arguments::load_named_character(
      folder_ / "scene.json", {}, "a glTF file, .glb or .gltf, or a prepared model");
  ASSERT_FALSE(scene);
  EXPECT_TRUE(contains(scene.error().message, "is not a model: give a glTF file"));
}

}  // namespace
}  // namespace pelt::test
