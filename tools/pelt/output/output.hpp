#pragma once

/// Output files of the command, and messages about unwritable files.

#include <pelt/result.hpp>

#include <ostream>
#include <string>

namespace pelt::tools::output {

/// The error for an output that cannot be written. `name`: as given by the user, a path or
/// kStandardOutput. `error`: the errno with the cause, or 0.
Error unwritable(const std::string& name, int error = 0);

/// Prints the name of a written file. Prints nothing for standard output and for "", which is no
/// file.
void print_written(const std::string& name, std::ostream& words);

/// Returns an error if any output to std::cout since the start was lost.
Result<void> flush_standard_output();

/// Opens closed standard streams in a mode that cannot be written, so that no file opened later
/// gets their descriptor and receives printed text.
void reserve_standard_streams();

}  // namespace pelt::tools::output
