#pragma once

#include <filesystem>
#include <string>

namespace pelt::tools::output {

/// Names standard output where a file is asked for.
inline constexpr const char* kStandardOutput = "-";

/// Where an output goes, links followed.
struct OutputPlace {
  enum class Kind {
    standard_output,
    descriptor,  ///< another one that the command was started with, such as /dev/stderr
    device,      ///< a device or a pipe, written in place
    file,        ///< a file to be replaced, or one that is not there yet
  };

  Kind kind = Kind::file;
  std::filesystem::path path;  ///< of a device or a file
  int descriptor = -1;
};

/// `name` as the user gave it: a path, which may lead to an open descriptor (/dev/stdout,
/// /dev/fd/3), or kStandardOutput.
OutputPlace find_output_place(const std::string& name);

/// Whether `name` leads to standard output.
bool is_standard_output(const std::string& name);

}  // namespace pelt::tools::output
