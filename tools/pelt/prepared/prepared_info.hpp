#pragma once

#include <pelt/result.hpp>

#include <string>

namespace pelt::tools::prepared {

enum class InfoStyle { text, json };

/// Tells on standard output what a prepared model holds.
Result<void> print_prepared_info(const std::string& path, InfoStyle style);

}  // namespace pelt::tools::prepared
