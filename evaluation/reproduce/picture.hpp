#pragma once

/// Pictures, rendered by POV-Ray.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>

namespace pelt::reproduce {

/// Renders the picture into the file `png`. If POV-Ray is missing, the error message says what to
/// do.
Result<void> render(const Picture& picture, const std::filesystem::path& png);

}  // namespace pelt::reproduce
