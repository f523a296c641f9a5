#pragma once

#include <span>
#include <string>

namespace pelt::tools::output {

enum class ProgramEnd { succeeded, failed, not_found };

/// Who is told when the user presses Ctrl+C: the program too, or only the one that runs it.
enum class CtrlC { ends_both, ends_caller };

/// Runs a program found on PATH, without a shell, and waits for its end. What it prints is lost. No
/// signal is blocked for it, whatever the caller has blocked.
ProgramEnd run_program(std::span<const std::string> words, CtrlC ctrl_c = CtrlC::ends_both);

}  // namespace pelt::tools::output
