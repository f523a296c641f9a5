#pragma once

/// Pictures, rendered by POV-Ray.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>

namespace pelt::reproduce {

/// Renders it into the file `png`. The message of an error says what to do where POV-Ray is
/// missing.
Result<void> render(const Picture& picture, const std::filesystem::path& png);

}  // namespace pelt::reproduce
