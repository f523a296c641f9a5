#pragma once

/// Output files of the command, and messages about unwritable files.

#include <pelt/result.hpp>

#include <ostream>
#include <string>

namespace pelt::tools::output {

/// The refusal of an output that cannot be written. `name` as the user gave it: a path or
/// kStandardOutput; `error` is the errno that says why, or 0.
Error unwritable(const std::string& name, int error = 0);

/// Tells people of a file that was written; of standard output and of "", which is no file,
/// nothing.
void print_written(const std::string& name, std::ostream& words);

/// Fails where any of what went to std::cout since the start is lost.
Result<void> flush_standard_output();

/// Opens those of the three standard streams that are closed, without a way to write to them, so
/// that no file opened later takes their place and receives what is printed.
void reserve_standard_streams();

}  // namespace pelt::tools::output
