#include "model/problem.hpp"

#include "base/format.hpp"

namespace pelt::detail {

Problem problem(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text = formatted(format, arguments);
  va_end(arguments);
  return text;
}

}  // namespace pelt::detail
