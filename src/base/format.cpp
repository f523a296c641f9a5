#include "base/format.hpp"

#include <cstdio>

namespace pelt::detail {

std::string formatted(const char* format, std::va_list arguments) {
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  return text;
}

}  // namespace pelt::detail
