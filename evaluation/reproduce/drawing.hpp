#pragma once

#include <pelt/result.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace pelt::reproduce {

/// A program that draws, and Debian's package of it.
struct DrawingProgram {
  const char *name, *package;
};

/// Writes `description` into a file, lets the program work by `command`, which names that file, and
/// removes it again unless the program failed. The message of an error says what to do.
Result<void> draw(const DrawingProgram& program, std::span<const std::string> command,
                  const std::filesystem::path& file, const std::string& description);

}  // namespace pelt::reproduce
