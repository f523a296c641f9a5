#include "tools/test_scenes.hpp"

#include <pelt/model.hpp>

namespace pelt::test {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(Prepare, WritesWhatTheLibraryLoads) {
  const TestFolder folder;
  write_bytes(folder / "limb.glb", swaying_limb(20));
  const Ended run = run_pelt(folder, 0, {"prepare", "limb.glb", "-o", "limb.pelt"});
  for (const char* words : {"limb.glb: ", " triangles", "6 poses of 1 clip", "wrote limb.pelt",
                            " bytes", "build", " times faster"})
    EXPECT_TRUE(contains(run.out, words));
  const auto file = bytes_of(read_text(folder / "limb.pelt"));
  const Result<SkinnedModel> model = load_model(file);
  ASSERT_TRUE(model) << model.error().message;
  const json info = json::parse(run_pelt(folder, {"info", "limb.glb", "--json"}).out);
  EXPECT_EQ(model->triangle_count(), info["triangles"]);
  EXPECT_EQ(model->vertex_count(), info["vertices"]);
}

TEST(Prepare, WritesTheSameBytesAgain) {
  const TestFolder folder;
  write_bytes(folder / "limb.glb", swaying_limb(20));
  for (const char* name : {"one.pelt", "two.pelt"})
    run_pelt(folder, 0, {"prepare", "limb.glb", "-o", name});
  EXPECT_EQ(read_text(folder / "one.pelt"), read_text(folder / "two.pelt"));
}

TEST(Prepare, InfoPrintsTheContents) {
  const StripFolder folder;
  run_pelt(folder, 0, {"prepare", "strip.glb", "-o", "strip.pelt"});
  const Ended run = run_pelt(folder, 0, {"info", "strip.pelt", "--json"});
  json info = json::parse(run.out);
  EXPECT_EQ(info["hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(info["prepared"]["bytes"], read_text(folder / "strip.pelt").size());
  info.erase("hash");
  info["prepared"].erase("bytes");
  EXPECT_EQ(info, json::parse(R"({
    "format": "pelt-info", "version": 1, "model": "strip.pelt", "prepared": {"version": 4},
    "vertices": 12, "triangles": 8, "degenerate_triangles": 0, "influences_per_vertex": 2,
    "renormalised_vertices": 0, "merged_influences": 0, "joint_count": 3,
    "nodes": 1, "clusters": 1})"));
  const Ended told = run_pelt(folder, {"info", "strip.pelt"});
  EXPECT_TRUE(contains(told.out, "version 4 of the format"));
}

TEST(Prepare, RefusesWhatIsDamaged) {
  const StripFolder folder;
  run_pelt(folder, 0, {"prepare", "strip.glb", "-o", "strip.pelt"});
  std::string text = read_text(folder / "strip.pelt");
  text.back() ^= 1;
  write_text(folder / "strip.pelt", text);
  const Ended run = run_pelt(folder, 2, {"info", "strip.pelt"});
  EXPECT_TRUE(contains(run.err, "strip.pelt: the prepared model is damaged"));
}

TEST(Prepare, WhereASkeletonIsNeededTheFileIsRefusedWithAdvice) {
  const StripFolder folder;
  run_pelt(folder, 0, {"prepare", "strip.glb", "-o", "strip.pelt"});
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"check", "strip.pelt"},
        std::vector<std::string>{"prepare", "strip.pelt", "-o", "again.pelt"}}) {
    const Ended run = run_pelt(folder, 2, arguments);
    EXPECT_TRUE(contains(run.err, "strip.pelt: is a prepared model"));
  }
}

TEST(Prepare, NamesWhatItCannotWrite) {
  const StripFolder folder;
  const Ended run = run_pelt(folder, 2, {"prepare", "strip.glb", "-o", "no/folder/a.pelt"});
  EXPECT_TRUE(contains(run.err, "no/folder/a.pelt: cannot be written"));
}

}  // namespace
}  // namespace pelt::test
