#pragma once

#include <cstdarg>
#include <string>

namespace pelt::detail {

/// What vsnprintf writes, cut off after 255 characters.
std::string formatted(const char* format, std::va_list arguments);

}  // namespace pelt::detail
