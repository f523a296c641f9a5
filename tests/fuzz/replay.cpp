/// TARGET_replay [--reach-all] FILE|FOLDER...: passes files to a fuzz target one after the other,
/// without libFuzzer, so that every build checks the seeds. Prints each file before it is passed;
/// after a failure, the last file printed is the one that failed. With --reach-all, also fails if
/// no file reached one of the goals of the target.

#include "fuzz/goal.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using pelt::test::Goal;

std::vector<std::filesystem::path> files_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool replay(const std::filesystem::path& path) {
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return true;
}

/// Prints how often each goal was reached. Returns whether all were.
bool print_goals() {
  bool all = true;
  for (const Goal* goal = Goal::first(); goal != nullptr; goal = goal->next()) {
    std::printf("%8llu %s\n", static_cast<unsigned long long>(goal->count()), goal->name());
    all = all && goal->count() > 0;
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const bool reach_all = argc > 1 && std::string_view(argv[1]) == "--reach-all";
  int count = 0;
  for (int i = reach_all ? 2 : 1; i < argc; ++i)
    for (const std::filesystem::path& path : files_in(argv[i])) {
      if (!replay(path)) return 2;
      ++count;
    }
  std::printf("%d files\n", count);
  if (count == 0) return 2;
  if (print_goals() || !reach_all) return 0;
  std::fprintf(stderr, "no seed reaches a goal with the count 0: add a seed that does\n");
  return 1;
}
