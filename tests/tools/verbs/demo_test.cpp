#include "tools/test_scenes.hpp"

#include <pelt/asset.hpp>
#include <pelt/version.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace pelt::test {
namespace {

/// The sword is before the arm in frame 5 and behind it in frame 6.
void expect_sword_between_frames(const TestFolder& folder) {
  run_pelt(folder, 0, {"check", "pelt-demo/sword.json"});
  const Ended between = run_pelt(
      folder, 1, {"check", "pelt-demo/sword.json", "--between", "--substeps", "4", "--jsonl", "-"});
  const json totals = json::parse(lines_of(between.out).back());
  EXPECT_EQ(totals["totals"]["contacts"], 0);
  const json& found = totals["totals"]["between"];
  EXPECT_EQ(found["steps"], 11);
  EXPECT_EQ(found["steps_in_contact"], 1);
  EXPECT_EQ(found["contacts"], 342);
  EXPECT_EQ(found["earliest"]["step"], 5);
  EXPECT_NEAR(found["earliest"]["first"].get<double>(), 0.1766, 5e-5);
  EXPECT_LT(found["deviation"]["distance"], 0.003);
  ASSERT_EQ(totals["touches_between"].size(), 1u);
  EXPECT_EQ(totals["touches_between"][0]["a"]["joint"], "fore_arm_l");
  EXPECT_EQ(totals["touches_between"][0]["b"]["joint"], "grip");
}

/// An empty PATH hides POV-Ray, so that the test is quick and the same everywhere.
TEST(Demo, WritesItsFilesWithoutARayTracer) {
  const TestFolder folder;
  const ViewerPage viewer(folder);
  const Ended run = run_pelt(folder, {"demo"}, "/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "apt-get install povray"));
  EXPECT_FALSE(std::filesystem::exists(folder / "pelt-demo/still.png"));
  EXPECT_TRUE(contains(run.out, "wrote pelt-demo/report.html\n"));
  EXPECT_TRUE(contains(read_text(folder / "pelt-demo/report.html"), "\"command\":\"pelt demo\""));

  const std::vector<std::string> lines = lines_of(read_text(folder / "pelt-demo/contacts.jsonl"));
  const json totals = json::parse(lines.back());
  EXPECT_EQ(totals["totals"]["frames"], 90);
  EXPECT_GT(totals["totals"]["frames_in_contact"], 10);
  EXPECT_LT(totals["totals"]["frames_in_contact"], 80);
  EXPECT_TRUE(asset::load_gltf(folder / "pelt-demo/contacts.glb"));
  const auto character = asset::load_gltf(folder / "pelt-demo/azure.glb");
  ASSERT_TRUE(character) << character.error().message;
  EXPECT_NE(character->find_clip("walk"), nullptr);

  expect_sword_between_frames(folder);

  // `check` accepts the scene that was written, and finds the same contacts.
  const Ended check = run_pelt(
      folder, 1, {"check", "pelt-demo/scene.json", "--frames", "40:41", "--jsonl", "-", "--pairs"});
  EXPECT_EQ(lines_of(check.out)[1], lines[41]);
}

/// A replacement for POV-Ray, which is slow, that only prints a word.
TEST(Demo, CallsTheRayTracer) {
  const TestFolder folder;
  write_text(folder / "povray", R"(#!/bin/sh
for word; do
  case "$word" in
    +I*) grep -q mesh2 "${word#+I}" || exit 1 ;;
    +O-) echo picture ;;
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

/// Starts the demo, in a process group of its own, with a replacement for POV-Ray that sleeps. The
/// number of its process is in the file "sleeping".
pid_t start_with_sleeping_ray_tracer(const TestFolder& folder) {
  write_text(folder / "povray", R"sh(#!/bin/sh
echo $$ > sleeping.new
mv sleeping.new sleeping
exec sleep 100
)sh");
  std::filesystem::permissions(folder / "povray", std::filesystem::perms::owner_all);
  const pid_t child = fork();
  if (child != 0) return child;
  setpgid(0, 0);
  setenv("PATH", (folder.path().string() + ":/usr/bin:/bin").c_str(), 1);
  if (chdir(folder.path().c_str()) == 0 && freopen("/dev/null", "w", stdout) != nullptr)
    execl(PELT_COMMAND, PELT_COMMAND, "demo", "-o", "demo", nullptr);
  _exit(127);
}

/// Whether the condition becomes true within a minute.
template <typename Condition>
bool becomes(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return condition();
}

/// A process that has ended but was not waited for has no command line, like one that starts
/// another program just now.
bool is_running(const std::string& process) {
  std::ifstream file("/proc/" + process + "/cmdline");
  return file.get() != std::char_traits<char>::eof();
}

/// A terminal sends its signals to the process group.
TEST(Demo, EndsTheRayTracerWhenASignalComes) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    const TestFolder folder;
    const pid_t demo = start_with_sleeping_ray_tracer(folder);
    EXPECT_TRUE(becomes([&] { return std::filesystem::exists(folder / "sleeping"); }));
    EXPECT_TRUE(std::filesystem::exists(folder / "demo/still.pov"));
    std::string sleeping = read_text(folder / "sleeping");
    sleeping.pop_back();
    EXPECT_TRUE(becomes([&] { return is_running(sleeping); }));
    kill(-demo, signal);
    int status = 0;
    waitpid(demo, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_TRUE(becomes([&] { return !is_running(sleeping); }));
    for (const std::string& name : names_in_path(folder / "demo")) {
      EXPECT_FALSE(name.starts_with(".pelt-")) << name;
      EXPECT_NE(name, "still.pov");
    }
  }
}

TEST(Demo, ReplacesOnlyADemo) {
  const TestFolder folder;
  for (const std::string name :
       {"scene.json", "azure.glb", "contacts.jsonl", "report.html", "still.pov", "still.png"}) {
    const std::string own = folder / name;
    write_text(own, "of the user");
    for (const std::string& option : {std::string("."), folder.path().string()}) {
      const Ended run = run_pelt(folder, {"demo", "-o", option}, "/nonexistent");
      EXPECT_EQ(run.exit_code, 2) << name;
      EXPECT_EQ(run.out, "");
      EXPECT_TRUE(
          contains(run.err, name + " exists, and is not of a demo: choose another folder with -o"));
    }
    EXPECT_EQ(read_text(own), "of the user");
    EXPECT_EQ(names_in(folder), std::set<std::string>{name});
    std::filesystem::remove(own);
  }
  write_text(folder / "notes.txt", "of the user");
  for (int i = 0; i < 2; ++i) {
    const Ended run = run_pelt(folder, {"demo", "-o", "."}, "/nonexistent");
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  std::ofstream(folder / "scene.json", std::ios::app) << ' ';  // an edited demo is the user's
  EXPECT_EQ(run_pelt(folder, {"demo", "-o", "."}, "/nonexistent").exit_code, 2);
  EXPECT_EQ(read_text(folder / "notes.txt"), "of the user");
}

TEST(Demo, KeepsTheDescriptionWhereTheRayTracerFails) {
  const TestFolder folder;
  write_text(folder / "povray", "#!/bin/sh\necho half a picture\nexit 1\n");
  std::filesystem::permissions(folder / "povray", std::filesystem::perms::owner_all);
  const Ended run =
      run_pelt(folder, {"demo", "-o", "demo"}, folder.path().string() + ":/usr/bin:/bin");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "no picture: POV-Ray failed on demo/still.pov"));
  const std::set<std::string> names = names_in_path(folder / "demo");
  EXPECT_TRUE(names.contains("still.pov"));
  EXPECT_FALSE(names.contains("still.png"));
  for (const std::string& name : names) EXPECT_FALSE(name.starts_with(".pelt-")) << name;
}

}  // namespace
}  // namespace pelt::test
