#pragma once

/// Calls the function of a program as if it ran in a process of its own.

#include <pelt/config.hpp>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace pelt::test {

/// A standard stream of this process, redirected to a file until the object is destroyed.
class RedirectedStream {
 public:
  explicit RedirectedStream(int descriptor);
  RedirectedStream(const RedirectedStream&) = delete;
  RedirectedStream& operator=(const RedirectedStream&) = delete;
  ~RedirectedStream();

  /// The text written so far.
  std::string text() const;

 private:
  int descriptor_, before_;
  std::FILE* file_;
};

/// Until the object is destroyed, this process works in `folder`, collects what it prints, and
/// finds programs on `search_path` (empty: on PATH). The destructor also restores the instruction
/// set.
class CalledProgram {
 public:
  CalledProgram(const std::filesystem::path& folder, const std::string& search_path);
  CalledProgram(const CalledProgram&) = delete;
  CalledProgram& operator=(const CalledProgram&) = delete;
  ~CalledProgram();

  std::string out() const { return out_.text(); }
  std::string err() const { return err_.text(); }

 private:
  const std::filesystem::path folder_before_ = std::filesystem::current_path();
  const InstructionSet instruction_set_before_ = active_instruction_set();
  std::optional<std::string> search_path_before_;
  RedirectedStream out_, err_;
};

}  // namespace pelt::test
