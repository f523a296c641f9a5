#pragma once

#include <pelt/result.hpp>

#include <cstdint>
#include <string>

namespace pelt::tools::page {

enum class Browser { opened, left_alone };

/// Serves one page to this machine alone, prints its address, and returns when SIGINT or SIGTERM
/// comes. `port` 0: any free one. A browser that cannot be opened is no failure.
Result<void> serve_page(const std::string& page, std::uint16_t port, Browser browser);

}  // namespace pelt::tools::page
