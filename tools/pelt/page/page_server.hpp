#pragma once

#include <pelt/result.hpp>

#include <cstdint>
#include <string>

namespace pelt::tools::page {

enum class Browser { opened, left_alone };

/// Serves one page to this machine only, prints its address, and returns on SIGINT or SIGTERM.
/// `port` 0 selects any free port. Failing to open a browser is not an error.
Result<void> serve_page(const std::string& page, std::uint16_t port, Browser browser);

}  // namespace pelt::tools::page
