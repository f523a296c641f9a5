#pragma once

#include <pelt/result.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace pelt::reproduce {

/// A drawing program and its Debian package.
struct DrawingProgram {
  const char *name, *package;
};

/// Writes `description` into a file, runs the program with `command`, which names that file, and
/// removes the file unless the program failed. The error message says what to do.
Result<void> draw(const DrawingProgram& program, std::span<const std::string> command,
                  const std::filesystem::path& file, const std::string& description);

}  // namespace pelt::reproduce
