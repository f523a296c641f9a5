#pragma once

/// Rejects outputs that would overwrite an input or each other.

#include <pelt/result.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace pelt::tools::output {

struct NamedOutput {
  std::string option;  ///< "--jsonl", for messages
  std::string name;    ///< as for find_output_place, or "" for nothing
  std::string remedy = "name another file";
};

/// A file that the command reads, or that such a file refers to.
struct InputFile {
  std::filesystem::path path;
  std::string role;  ///< "the model knight.glb", for messages
};

/// Returns an error for an output that is an input, another output, or the file that standard
/// output goes to, and for standard output that goes to an input. Follows symbolic and hard links,
/// and identifies descriptors such as /dev/stdin and /dev/fd/9 by the files that they are open for.
/// Two outputs may both go to /dev/null, but not to another device or pipe. Names that differ only
/// in the case of ASCII letters count as equal, as in some file systems. Call before anything is
/// written, also without outputs. O((outputs + inputs)^2 string comparisons) in the worst case.
Result<void> check_outputs(std::span<const NamedOutput> outputs, std::span<const InputFile> inputs);

/// Whether the shell redirects standard output to a regular file, which may be an input.
bool is_standard_output_a_file();

}  // namespace pelt::tools::output
