#include "tools/pelt/arguments/memory_limit.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace pelt::tools::arguments {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t minus(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

/// Returns the number after `key` in a file of keys and numbers, or `otherwise`.
std::uint64_t number_after(const fs::path& file, std::string_view key, std::uint64_t otherwise) {
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::string name;
    std::uint64_t number = 0;
    if (words >> name >> number && name == key) return number;
  }
  return otherwise;
}

/// Returns the number in a file of one number. Other text, such as "max", is no limit.
std::uint64_t number_in(const fs::path& file) {
  std::uint64_t number = 0;
  return std::ifstream(file) >> number ? number : kUnlimited;
}

std::uint64_t free_on_machine(const fs::path& root) {
  const fs::path file = root / "proc/meminfo";
  const std::uint64_t available = number_after(file, "MemAvailable:", kUnlimited);
  if (available == kUnlimited) return kUnlimited;
  return 1024 * (available + number_after(file, "SwapFree:", 0));
}

/// The files of a version of cgroups that state the memory of a group and of the groups below it.
struct CgroupFiles {
  const char* mount;
  const char* limit;
  const char* usage;
  const char* inactive_cache;
  const char* active_cache;
};

constexpr CgroupFiles kVersion1 = {"sys/fs/cgroup/memory", "memory.limit_in_bytes",
                                   "memory.usage_in_bytes", "total_inactive_file",
                                   "total_active_file"};
constexpr CgroupFiles kVersion2 = {"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file",
                                   "active_file"};

std::uint64_t free_in_cgroup(const fs::path& group, const CgroupFiles& files) {
  const std::uint64_t limit = number_in(group / files.limit);
  const std::uint64_t usage = number_in(group / files.usage);
  if (limit == kUnlimited || usage == kUnlimited) return kUnlimited;
  const fs::path statistics = group / "memory.stat";
  const std::uint64_t cache = number_after(statistics, files.inactive_cache, 0) +
                              number_after(statistics, files.active_cache, 0);
  return minus(limit, minus(usage, cache));
}

/// Each group is limited by its own limit and by those of the groups that contain it. In a
/// container, `path` may begin with groups outside its mount; they have no folder.
std::uint64_t free_in_cgroups(const fs::path& root, fs::path path, const CgroupFiles& files) {
  std::uint64_t least = free_in_cgroup(root / files.mount, files);
  for (; !path.empty(); path = path.parent_path())
    least = std::min(least, free_in_cgroup(root / files.mount / path, files));
  return least;
}

bool lists(std::string_view controllers, std::string_view name) {
  while (!controllers.empty()) {
    const std::size_t end = std::min(controllers.find(','), controllers.size());
    if (controllers.substr(0, end) == name) return true;
    controllers.remove_prefix(std::min(end + 1, controllers.size()));
  }
  return false;
}

/// Each line of /proc/self/cgroup is NUMBER:CONTROLLERS:/PATH. Version 2 has no controllers.
std::uint64_t free_in_cgroups_of_line(const fs::path& root, const std::string& line) {
  const std::size_t first = line.find(':');
  const std::size_t second = first == line.npos ? line.npos : line.find(':', first + 1);
  if (second == line.npos) return kUnlimited;
  const std::string controllers = line.substr(first + 1, second - first - 1);
  const fs::path path = fs::path(line.substr(second + 1)).relative_path();
  if (controllers.empty()) return free_in_cgroups(root, path, kVersion2);
  return lists(controllers, "memory") ? free_in_cgroups(root, path, kVersion1) : kUnlimited;
}

}  // namespace

std::uint64_t free_memory(const fs::path& root) {
  std::uint64_t least = free_on_machine(root);
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
    least = std::min(least, free_in_cgroups_of_line(root, line));
  return least;
}

void limit_memory() {
#if defined(__linux__)
  const std::uint64_t all = free_memory();
  const std::uint64_t free = all - all / 32;  // the rest is for page tables and the kernel
  // Linux counts reserved memory, which sanitizers reserve in large amounts before `main`.
  const std::uint64_t used = 1024 * number_after("/proc/self/status", "VmData:", 0);
  rlimit limit = {};
  if (all == kUnlimited || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<std::uint64_t>(limit.rlim_cur, used + free);
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

}  // namespace pelt::tools::arguments
