#pragma once

#include <span>
#include <string>

namespace pelt::tools::output {

enum class ProgramEnd { succeeded, failed, not_found };

/// Whether Ctrl+C, and any other signal that ends the caller, also kills the program and its
/// children, or leaves them alone. `ends_both` requires remove_unfinished_files_on_signals
/// (unfinished_files.hpp).
enum class CtrlC { ends_both, ends_caller };

/// Runs a program found on PATH, without a shell, and waits for its end. Discards its output.
/// Blocks no signals for the program, whatever the caller has blocked.
ProgramEnd run_program(std::span<const std::string> words, CtrlC ctrl_c = CtrlC::ends_both);

}  // namespace pelt::tools::output
