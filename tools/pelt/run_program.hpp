#pragma once

#include <span>
#include <string>

namespace pelt::tools {

enum class ProgramEnd { succeeded, failed, not_found };

/// Runs a program found on PATH, without a shell, and waits for its end. What it prints is lost.
ProgramEnd run_program(std::span<const std::string> words);

}  // namespace pelt::tools
