#pragma once

/// Output files of the command, and messages about unwritable files.

#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>

namespace pelt::tools::output {

/// File name that means standard output.
inline constexpr const char* kStandardOutput = "-";

/// `name` as the user gave it: a path or kStandardOutput.
Error unwritable(const std::string& name);

Result<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Tells people of a file that was written; of standard output and of "", which is no file,
/// nothing.
void print_written(const std::string& name, std::ostream& words);

/// Whether a file can be written there, asked before long work; what it holds stays.
Result<void> check_writable(const std::filesystem::path& path);

/// Fails where any of what went to std::cout since the start is lost.
Result<void> flush_standard_output();

/// Opens those of the three standard streams that are closed, without a way to write to them, so
/// that no file opened later takes their place and receives what is printed.
void reserve_standard_streams();

}  // namespace pelt::tools::output
