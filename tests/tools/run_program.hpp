#pragma once

/// Runs programs, mainly the command under test.

#include "support/contains.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pelt::test {

using Words = std::vector<std::string>;

/// Both lists, one after the other.
inline Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Ended {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string out, err;
};

/// A folder for one test, empty at first and deleted at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Runs a program found on PATH, in `folder`. If `search_path` is not empty, it replaces PATH.
Ended run_program(const std::filesystem::path& folder, const Words& words,
                  const std::string& search_path = "");

/// Runs the command with these arguments in `folder`. Does not start a process: use `run_program`
/// with PELT_COMMAND for tests of signals, pipes, limits or closed streams.
Ended run_pelt(const TestFolder& folder, const Words& arguments,
               const std::string& search_path = "");

/// The same, and expects this exit code.
Ended run_pelt(const TestFolder& folder, int exit_code, const Words& arguments);

/// The names in a folder.
std::set<std::string> names_in(const TestFolder& folder);
std::set<std::string> names_in_path(const std::filesystem::path& folder);

std::string read_text(const std::filesystem::path& path);
std::vector<std::string> lines_of(const std::string& text);

}  // namespace pelt::test
