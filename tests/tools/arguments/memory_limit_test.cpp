#include "tools/pelt/arguments/memory_limit.hpp"

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <limits>

namespace pelt::tools::arguments {
namespace {

constexpr std::uint64_t kMegabyte = 1 << 20;

/// A folder with the files of /proc and /sys/fs/cgroup.
class FreeMemory : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    test::write_text(path, text);
  }
  void write_machine(std::uint64_t megabytes) {
    write("proc/meminfo", "MemTotal:  99999999 kB\nMemAvailable:  " +
                              std::to_string(1024 * megabytes) + " kB\nSwapFree:    0 kB\n");
  }
  void write_group(const std::string& folder, std::uint64_t limit, std::uint64_t usage) {
    write(folder + "/memory.max", std::to_string(limit * kMegabyte) + "\n");
    write(folder + "/memory.current", std::to_string(usage * kMegabyte) + "\n");
  }
  std::uint64_t megabytes() const { return free_memory(folder_.path()) / kMegabyte; }

  test::TestFolder folder_;
};

TEST_F(FreeMemory, IsUnlimitedWithoutFiles) {
  EXPECT_EQ(free_memory(folder_.path()), std::numeric_limits<std::uint64_t>::max());
}

TEST_F(FreeMemory, CountsSwap) {
  write("proc/meminfo", "MemFree: 1 kB\nMemAvailable:     3072 kB\nSwapFree:   2048 kB\n");
  EXPECT_EQ(megabytes(), 5u);
}

TEST_F(FreeMemory, IsLimitedByCgroupsOfVersion2) {
  write_machine(1000);
  write("proc/self/cgroup", "0::/outer/inner\n");
  write("sys/fs/cgroup/outer/inner/memory.max", "max\n");
  write("sys/fs/cgroup/outer/inner/memory.current", "1000000\n");
  EXPECT_EQ(megabytes(), 1000u);
  write_group("sys/fs/cgroup/outer", 400, 100);
  EXPECT_EQ(megabytes(), 300u);
  write_group("sys/fs/cgroup/outer/inner", 200, 150);
  EXPECT_EQ(megabytes(), 50u);
}

TEST_F(FreeMemory, CountsThePageCacheAsFree) {
  write_machine(1000);
  write("proc/self/cgroup", "0::/\n");
  write_group("sys/fs/cgroup", 200, 150);
  write("sys/fs/cgroup/memory.stat", "anon 9\nfile 99\ninactive_file " +
                                         std::to_string(30 * kMegabyte) + "\nactive_file " +
                                         std::to_string(10 * kMegabyte) + "\n");
  EXPECT_EQ(megabytes(), 90u);
}

TEST_F(FreeMemory, IsLimitedByCgroupsOfVersion1) {
  write_machine(1000);
  write("proc/self/cgroup", "5:cpu,cpuacct:/x\n4:hugetlb,memory:/abc\n0::/\n");
  const std::string folder = "sys/fs/cgroup/memory/abc/";
  write(folder + "memory.limit_in_bytes", std::to_string(600 * kMegabyte) + "\n");
  write(folder + "memory.usage_in_bytes", std::to_string(700 * kMegabyte) + "\n");
  EXPECT_EQ(megabytes(), 0u);
  write(folder + "memory.stat", "total_inactive_file " + std::to_string(200 * kMegabyte) + "\n");
  EXPECT_EQ(megabytes(), 100u);
  write(folder + "memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(megabytes(), 1000u);
}

/// A container sees its own group at the mount, but may see the path on the host.
TEST_F(FreeMemory, IsLimitedByTheGroupAtTheMount) {
  write_machine(1000);
  write("proc/self/cgroup", "4:memory:/docker/abc\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(70 * kMegabyte) + "\n");
  write("sys/fs/cgroup/memory/memory.usage_in_bytes", std::to_string(20 * kMegabyte) + "\n");
  EXPECT_EQ(megabytes(), 50u);
}

}  // namespace
}  // namespace pelt::tools::arguments
