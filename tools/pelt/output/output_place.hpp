#pragma once

#include <filesystem>
#include <string>

namespace pelt::tools::output {

/// The name of standard output as a file argument.
inline constexpr const char* kStandardOutput = "-";

/// The destination of an output, with links resolved.
struct OutputPlace {
  enum class Kind {
    standard_output,
    descriptor,  ///< another inherited descriptor, such as /dev/stderr
    device,      ///< a device or a pipe, written directly
    file,        ///< a file to replace or to create
  };

  Kind kind = Kind::file;
  std::filesystem::path path;  ///< of a device or a file
  int descriptor = -1;
};

/// `name`: as given by the user, a path (which may refer to an open descriptor: /dev/stdout,
/// /dev/fd/3) or kStandardOutput.
OutputPlace find_output_place(const std::string& name);

/// Whether `name` refers to standard output.
bool is_standard_output(const std::string& name);

}  // namespace pelt::tools::output
