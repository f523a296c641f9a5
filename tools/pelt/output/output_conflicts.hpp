#pragma once

/// Refusal of outputs that would destroy an input or each other.

#include <pelt/result.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace pelt::tools::output {

struct NamedOutput {
  std::string option;  ///< "--jsonl", for messages
  std::string name;    ///< as for find_output_place, or "" for nothing
};

/// A file that the command reads, or that a file it reads names.
struct InputFile {
  std::filesystem::path path;
  std::string role;  ///< "the model knight.glb", for messages
};

/// Refuses an output that is one of the inputs, another output, or the file that standard output
/// goes to. Follows links, symbolic and hard ones; names that differ only in the case of ASCII
/// letters are the same, as some file systems have it. To be asked before anything is written.
/// O((outputs + inputs)^2 string compares) at worst.
Result<void> check_outputs(std::span<const NamedOutput> outputs, std::span<const InputFile> inputs);

}  // namespace pelt::tools::output
