#include "evaluation/reproduce/experiment.hpp"
#include "tools/run_program.hpp"

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
  if (reproduce::peers_experiment() != nullptr) GTEST_SKIP() << "built with them";
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

TEST(Reproduce, RefusesModelsThatAreNoFolder) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"reproduce", "--only", "characters", "--models", "nowhere"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("nowhere"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace pelt::test
