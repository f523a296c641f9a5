#pragma once

#include <pelt/result.hpp>

#include <string>

namespace pelt::tools::prepared {

enum class InfoStyle { text, json };

/// Prints the contents of a prepared model to standard output.
Result<void> print_prepared_info(const std::string& path, InfoStyle style);

}  // namespace pelt::tools::prepared
