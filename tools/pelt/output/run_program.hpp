#pragma once

#include <span>
#include <string>

namespace pelt::tools::output {

enum class ProgramEnd { succeeded, failed, not_found };

/// Runs a program found on PATH and waits for its end. Appends what it prints to `printed` if that
/// is not null, and discards its messages. Ctrl+C ends the program, too, because it belongs to the
/// process group of the command.
ProgramEnd run_program(std::span<const std::string> words, std::string* printed = nullptr);

/// Quotes a word for a shell if necessary.
std::string shell_word(const std::string& word);

}  // namespace pelt::tools::output
