#include "base/problem.hpp"

#include <cstdarg>
#include <cstdio>

namespace pelt::detail {

Problem problem(const char* format, ...) {
  char text[256];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

}  // namespace pelt::detail
