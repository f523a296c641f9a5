/// If memory is insufficient, the message names the file, and it is not an internal error.

#include "support/sanitizers.hpp"
#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace pelt::test {
namespace {

/// Writes a sparse file, which by default is larger than the memory limit of `run_limited`.
void write_huge(const TestFolder& folder, const std::string& name, const std::string& beginning,
                std::uintmax_t bytes = std::uintmax_t{1} << 36) {
  std::ofstream(folder / name) << beginning;
  std::filesystem::resize_file(folder / name, bytes);
}

/// A memory cgroup with a limit, for programs of this test. Only root can make one.
class MemoryGroup {
 public:
  explicit MemoryGroup(std::uint64_t bytes) {
    const std::string name = "pelt-test-" + std::to_string(getpid());
    const bool version1 = std::filesystem::exists("/sys/fs/cgroup/memory");
    path_ = std::filesystem::path(version1 ? "/sys/fs/cgroup/memory" : "/sys/fs/cgroup") / name;
    std::error_code error;
    if (!std::filesystem::create_directory(path_, error)) return;
    std::ofstream limit(path_ / (version1 ? "memory.limit_in_bytes" : "memory.max"));
    exists_ = static_cast<bool>(limit << bytes << std::flush);
  }
  MemoryGroup(const MemoryGroup&) = delete;
  MemoryGroup& operator=(const MemoryGroup&) = delete;
  ~MemoryGroup() { rmdir(path_.c_str()); }

  bool exists() const { return exists_; }

  Ended run(const TestFolder& folder, const std::string& arguments) const {
    const std::string join = "echo $$ > '" + (path_ / "cgroup.procs").string() + "' && ";
    return run_program(folder.path(), {"sh", "-c", join + "exec '" PELT_COMMAND "' " + arguments});
  }

 private:
  std::filesystem::path path_;
  bool exists_ = false;
};

Ended run_limited(const TestFolder& folder, const std::string& arguments,
                  std::uint32_t megabytes = 4000) {
  return run_program(folder.path(), {"sh", "-c",
                                     "ulimit -v " + std::to_string(1000 * megabytes) +
                                         "; '" PELT_COMMAND "' " + arguments});
}

/// Unskinned parts of one triangle in a row, three units apart, each with a joint of its own.
void write_dust(const TestFolder& folder, const std::string& name, std::uint32_t parts) {
  std::string numbers, nodes;
  for (std::uint32_t p = 0; p < parts; ++p) {
    numbers += (p > 0 ? "," : "") + std::to_string(p);
    nodes += (p > 0 ? R"(,{"mesh":0,"translation":[)" : R"({"mesh":0,"translation":[)") +
             std::to_string(3 * p) + ",0,0]}";
  }
  std::ofstream(folder / name)
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" << numbers
      << R"(]}],"nodes":[)" << nodes
      << R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      << R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      << R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
      << R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

class MemoryLimit : public ::testing::Test {
 protected:
  void SetUp() override {
    if (kHasSanitizer) GTEST_SKIP() << "sanitizers reserve more address space than the limit";
  }

  void expect_named(const std::string& arguments, const std::string& name) {
    const Ended run = run_limited(folder_, arguments);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_TRUE(contains(run.err, name));
    EXPECT_TRUE(contains(run.err, "needs more memory than there is"));
  }

  TestFolder folder_;
};

TEST_F(MemoryLimit, NamesAHugeModel) {
  write_huge(folder_, "huge.glb", "glTF");
  expect_named("info huge.glb", "huge.glb");
  expect_named("check huge.glb", "huge.glb");
}

TEST_F(MemoryLimit, RefusesAHugeFileOfAnotherFormatByItsBeginning) {
  write_huge(folder_, "huge.glb", "solid");
  for (const char* verb : {"info huge.glb", "check huge.glb"}) {
    const Ended run = run_limited(folder_, verb);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_TRUE(contains(run.err, "huge.glb: the file starts neither like a .glb"));
  }
}

/// Linux grants memory beyond the limit of a cgroup, and kills the process that uses it.
TEST_F(MemoryLimit, NamesAModelLargerThanItsMemoryGroup) {
  const MemoryGroup group(100'000'000);
  if (!group.exists()) GTEST_SKIP() << "cannot make a memory cgroup";
  write_huge(folder_, "huge.glb", "glTF", 1'000'000'000);
  for (const char* verb : {"info huge.glb", "check huge.glb"}) {
    const Ended run = group.run(folder_, verb);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_TRUE(contains(run.err, "huge.glb: needs more memory than there is"));
  }
  // The tree of a model whose file is small.
  write_text(folder_ / "scene.json", R"({"models": {"a": {"creature": {"triangles": 1000000}}},
                                         "instances": [{"model": "a"}]})");
  const Ended run = group.run(folder_, "bounds scene.json");
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_TRUE(contains(run.err, "scene.json: "));
  EXPECT_TRUE(contains(run.err, "needs more memory than there is"));
  write_bytes(folder_ / "limb.glb", swaying_limb(8));
  EXPECT_EQ(group.run(folder_, "info limb.glb").exit_code, 0);
}

TEST_F(MemoryLimit, NamesAHugeScene) {
  write_huge(folder_, "scene.json", "{");
  expect_named("check scene.json", "scene.json");
}

TEST_F(MemoryLimit, NamesAHugeBuffer) {
  write_huge(folder_, "body.bin", "");
  std::ofstream(folder_ / "body.gltf")
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      << R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      << R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      << R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
      << R"("buffers":[{"byteLength":36,"uri":"body.bin"}]})";
  expect_named("info body.gltf", "body.bin");
}

/// A limb whose JSON text has many values that Pelt does not read.
void write_wordy_limb(const TestFolder& folder, const std::string& name) {
  GltfBuilder builder = build_limb(200);
  json& extras = builder.document["extras"] = json::array();
  for (int i = 0; i < 20000; ++i) extras.push_back({{"a", {i, {i}}}});
  write_bytes(folder / name, builder.glb());
}

/// The command ends in order under any limit that lets it start.
TEST_F(MemoryLimit, NamesTheModelWhereverItIsReached) {
  write_wordy_limb(folder_, "limb.glb");
  for (const std::string verb : {"info limb.glb --json", "check limb.glb limb.glb --fail-on never",
                                 "pose limb.glb --frame 1 -o posed.glb"}) {
    std::size_t failures = 0;
    for (std::uint32_t megabytes = 40; megabytes > 5; --megabytes) {
      const Ended run = run_limited(folder_, verb, megabytes);
      if (run.exit_code == 127 || run.err.find("memory to start") != std::string::npos) break;
      if (run.exit_code == 0) continue;
      ++failures;
      EXPECT_EQ(run.exit_code, 2) << verb << " within " << megabytes << " MB: " << run.err;
      EXPECT_TRUE(contains(run.err, "pelt: error: limb.glb"));
      EXPECT_TRUE(contains(run.err, "needs more memory than there is"));
      EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    }
    EXPECT_GT(failures, 3u) << verb;
  }
}

/// The joints of all instances in one frame take 108 MB.
TEST_F(MemoryLimit, NamesTheSceneAfterItIsLoaded) {
  std::string scene = R"({"models": {"a": {"creature": {"triangles": 2000, "joints": 56}}},
                          "instances": [{"model": "a"})";
  for (int i = 0; i < 30000; ++i) scene += R"(, {"model": "a"})";
  write_text(folder_ / "scene.json", scene + "]}");
  const Ended run = run_limited(folder_, "bounds scene.json --frames 0:1", 100);
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_EQ(run.err,
            "pelt: error: scene.json: pelt bounds needs more memory than there is: free some, or "
            "use fewer or smaller characters\n");
}

/// A palette of all joints for each part would take 4.1 GB.
TEST_F(MemoryLimit, SufficesForParts) {
  write_dust(folder_, "dust.gltf", 8000);
  for (const char* verb : {"check dust.gltf --by part", "check dust.gltf --by part --clearance 0.5",
                           "bounds dust.gltf --by part"}) {
    const Ended run = run_limited(folder_, verb, 800);
    EXPECT_EQ(run.exit_code, 0) << verb << ": " << run.err;
    EXPECT_TRUE(contains(run.out, "8,000 parts"));
  }
}

}  // namespace
}  // namespace pelt::test
