#include "evaluation/reproduce/report.hpp"
#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

TEST(Reproduce, WritesAReport) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--quick", "--only", "characters", "-o", "r"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("[1 of 1]"), std::string::npos) << run.out;
  EXPECT_NE(read_text(folder / "r/report.html").find("generated creature"), std::string::npos);
  EXPECT_NE(read_text(folder / "r/results.json").find("\"pelt-reproduce\""), std::string::npos);
  EXPECT_EQ(lines_of(read_text(folder / "r/csv/characters.csv")).size(), 4u);
}

/// An empty PATH hides all programs.
TEST(Reproduce, SaysOnceWhatToInstallForTheCharts) {
  const TestFolder folder;
  const Ended run =
      run_pelt(folder, {"reproduce", "--quick", "--only", "tightness", "-o", "r"}, "/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::size_t told = run.out.find("apt-get install gnuplot-nox");
  ASSERT_NE(told, std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("apt-get install gnuplot-nox", told + 1), std::string::npos);
  EXPECT_NE(read_text(folder / "r/report.html").find("(not drawn:"), std::string::npos);
}

TEST(Reproduce, RefusesAnUnknownExperiment) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--only", "tigthness"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("did you mean \"tightness\""), std::string::npos) << run.err;
}

TEST(Reproduce, SaysHowToBuildWithOtherLibraries) {
  if (reproduce::peers_experiment() != nullptr)
    GTEST_SKIP() << "this build has the other libraries";
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--peers"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("PELT_BENCH_PEERS=ON"), std::string::npos) << run.err;
}

TEST(Reproduce, RefusesAFolderThatIsAFile) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--only", "characters", "-o", "/dev/null"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("/dev/null"), std::string::npos) << run.err;
}

/// Also through links, and before any experiment runs.
TEST(Reproduce, ReplacesNoModelAndNoFileOfAModel) {
  const TestFolder folder;
  GltfBuilder builder = build_limb(12);
  builder.document["images"] = {{{"uri", "skin.png"}}};
  std::filesystem::create_directory(folder / "models");
  write_bytes(folder / "models/limb.glb", builder.glb());
  write_text(folder / "models/skin.png", "picture");
  for (const char* file : {"report.html", "results.json", "csv/characters.csv"}) {
    for (const char* input : {"limb.glb", "skin.png"}) {
      std::filesystem::remove_all(folder / "r");
      std::filesystem::create_directories(folder / "r/csv");
      const std::string original = folder / (std::string("models/") + input);
      std::filesystem::create_symlink(original, folder / (std::string("r/") + file));
      const std::string before = read_text(original);
      const Ended run = run_pelt(folder, {"reproduce", "--quick", "--only", "characters",
                                          "--models", "models", "-o", "r"});
      EXPECT_EQ(run.exit_code, 2);
      EXPECT_EQ(run.out, "");
      EXPECT_NE(run.err.find(std::string("-o: r/") + file + " is "), std::string::npos) << run.err;
      EXPECT_NE(run.err.find("choose another folder"), std::string::npos) << run.err;
      EXPECT_EQ(read_text(original), before);
    }
  }
}

TEST(Reproduce, RefusesModelsThatAreNoFolder) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--only", "characters", "--models", "nowhere"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("nowhere"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace pelt::test
