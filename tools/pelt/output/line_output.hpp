#pragma once

#include <pelt/result.hpp>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

namespace pelt::tools::output {

/// --jsonl's file, standard output, or nothing. A file is whole or as it was before: it is written
/// beside its place, as FILE.partial, and moved there by `close`. What is no file (a pipe, a
/// device) is written as it comes.
class LineOutput {
 public:
  LineOutput() = default;
  LineOutput(const LineOutput&) = delete;
  LineOutput& operator=(const LineOutput&) = delete;

  /// Without `close`, discards what was written.
  ~LineOutput();

  /// `path` may be kStandardOutput, or "" for nothing.
  Result<void> open(const std::string& path);

  /// Null where there is nothing to write to.
  std::ostream* stream() { return stream_; }

  /// Fails where any line is lost.
  Result<void> close();

 private:
  void open_file();
  bool move_into_place();

  std::string path_;
  std::filesystem::path place_, partial_;  // links followed; "": not moved, but written there
  std::ofstream file_;
  std::ostream* stream_ = nullptr;
};

/// Stream for the summary: standard error if the lines go to standard output.
std::ostream& words_beside(const std::string& jsonl);

}  // namespace pelt::tools::output
