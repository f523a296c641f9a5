#include "tools/test_scenes.hpp"

#include <pelt/asset.hpp>
#include <pelt/version.hpp>

#include <cstdlib>

namespace pelt::test {
namespace {

/// An empty PATH hides POV-Ray, so that the test is quick and the same everywhere.
TEST(Demo, WritesItsFilesWithoutARayTracer) {
  const TestFolder folder;
  write_text(folder / "viewer.html", viewer_page(PELT_VERSION));
  ASSERT_EQ(setenv("PELT_VIEWER", (folder / "viewer.html").c_str(), 1), 0);
  const Ended run = run_pelt(folder, {"demo"}, "/nonexistent");
  unsetenv("PELT_VIEWER");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("apt-get install povray"), std::string::npos) << run.out;
  EXPECT_FALSE(std::filesystem::exists(folder / "pelt-demo/still.png"));
  EXPECT_NE(run.out.find("wrote pelt-demo/report.html\n"), std::string::npos) << run.out;
  EXPECT_NE(read_text(folder / "pelt-demo/report.html").find("\"command\":\"pelt demo\""),
            std::string::npos);

  const std::vector<std::string> lines = lines_of(read_text(folder / "pelt-demo/contacts.jsonl"));
  const json totals = json::parse(lines.back());
  EXPECT_EQ(totals["totals"]["frames"], 90);
  EXPECT_GT(totals["totals"]["frames_in_contact"], 10);
  EXPECT_LT(totals["totals"]["frames_in_contact"], 80);
  EXPECT_TRUE(asset::load_gltf(folder / "pelt-demo/contacts.glb"));
  const auto character = asset::load_gltf(folder / "pelt-demo/azure.glb");
  ASSERT_TRUE(character) << character.error().message;
  EXPECT_NE(character->find_clip("walk"), nullptr);

  // `check` accepts the scene that was written, and finds the same contacts.
  const Ended check = run_pelt(
      folder, {"check", "pelt-demo/scene.json", "--frames", "40:41", "--jsonl", "-", "--pairs"});
  ASSERT_EQ(check.exit_code, 1) << check.err;
  EXPECT_EQ(lines_of(check.out)[1], lines[41]);
}

/// A replacement for POV-Ray, which is slow, that only writes a file.
TEST(Demo, CallsTheRayTracer) {
  const TestFolder folder;
  write_text(folder / "povray", R"(#!/bin/sh
for word; do
  case "$word" in
    +I*) grep -q mesh2 "${word#+I}" || exit 1 ;;
    +O*) echo picture > "${word#+O}" ;;
  esac
done
)");
  std::filesystem::permissions(folder / "povray", std::filesystem::perms::owner_all);
  const Ended run =
      run_pelt(folder, {"demo", "-o", "a/b"}, folder.path().string() + ":/usr/bin:/bin");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(read_text(folder / "a/b/still.png"), "picture\n");
  for (const char* name : {"scene.json", "contacts.jsonl", "contacts.glb"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "a/b" / name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a/b/still.pov"));
}

}  // namespace
}  // namespace pelt::test
