#include "tools/pelt/output/process.hpp"

#include "text/format.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string_view>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// The bytes that a file of /proc states in kB after `key`; 0 if it does not.
std::uint64_t bytes_after(const char* file, std::string_view key) {
  std::ifstream words(file);
  for (std::string word; words >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == key && words >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

/// The least limit of a cgroup and of the groups that contain it. In a container, `group` may begin
/// with groups outside its mount; they have no folder.
std::uint64_t least_limit(const fs::path& mount, const fs::path& group, const char* file) {
  std::uint64_t least = kUnlimited, limit = 0;
  for (fs::path inner = group;; inner = inner.parent_path()) {
    if (std::ifstream(mount / inner / file) >> limit) least = std::min(least, limit);
    if (inner.empty()) return least;
  }
}

/// Each line of /proc/self/cgroup is NUMBER:CONTROLLERS:/PATH. Version 2 has no controllers.
std::uint64_t limit_of_cgroups() {
  std::uint64_t least = kUnlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t path = line.find(":/");
    if (path == line.npos) continue;
    const fs::path group = line.substr(path + 2);
    if (line.starts_with("0::"))
      least = std::min(least, least_limit("/sys/fs/cgroup", group, "memory.max"));
    else if (line.find("memory") < path)
      least = std::min(least, least_limit("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

/// A file that is or was unfinished. A signal handler must not allocate or lock, and may come at
/// any time, so the list of these files only grows.
struct KnownFile {
  std::string path;
  std::atomic<bool> is_unfinished = true;
  KnownFile* next = nullptr;
};
std::atomic<KnownFile*> newest_file = nullptr;

KnownFile& register_file(const fs::path& path) {
  KnownFile* const file = new KnownFile{path.string()};
  file->next = newest_file.load();
  newest_file = file;
  return *file;
}

void remove_and_end(int signal) {
  for (const KnownFile* file = newest_file; file != nullptr; file = file->next) {
    if (file->is_unfinished) unlink(file->path.c_str());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = fcntl(stream, F_GETFD) == -1;
    if (closed) open("/dev/null", O_RDONLY);  // gets the lowest free number, which is this one
  }
}

void limit_memory() {
#if defined(__linux__)
  const std::uint64_t available = bytes_after("/proc/meminfo", "MemAvailable:");
  if (available == 0) return;
  const std::uint64_t all =
      std::min(available + bytes_after("/proc/meminfo", "SwapFree:"), limit_of_cgroups());
  // Page tables and the kernel need the rest. Sanitizers reserve large amounts before `main`.
  const std::uint64_t most = bytes_after("/proc/self/status", "VmData:") + all - all / 32;
  rlimit limit = {};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<std::uint64_t>(limit.rlim_cur, most);
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

void remove_unfinished_files_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
    if (std::signal(signal, remove_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

UnfinishedFile::UnfinishedFile(const fs::path& path)
    : is_registered_(register_file(path).is_unfinished) {}

UnfinishedFile::~UnfinishedFile() { is_registered_ = false; }

ProgramEnd run_program(std::span<const std::string> words, std::string* printed) {
  constexpr int kNotFound = 127;  // the exit code of a shell that does not find the program
  std::string command = "exec";
  for (const std::string& word : words) command.append(" ").append(text::shell_word(word));
  command += printed == nullptr ? " >/dev/null 2>&1" : " 2>/dev/null";
  std::FILE* const output = popen(command.c_str(), "r");
  if (output == nullptr) return ProgramEnd::failed;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), output))
    if (printed != nullptr) printed->append(part.data(), count);
  const int status = pclose(output);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) return ProgramEnd::not_found;
  return status == 0 ? ProgramEnd::succeeded : ProgramEnd::failed;
}

}  // namespace pelt::tools::output
