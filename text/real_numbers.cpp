/// Reads and prints floating-point numbers. Not in the npm package: the C++ library of Emscripten
/// can do neither without loss.

#include "text/format.hpp"
#include "text/message.hpp"

#include <charconv>
#include <cmath>

namespace pelt::text {

bool parse_number(std::string_view text, double& value) {
  double parsed;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, parsed);
  if (error != std::errc() || stop != end || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

Error number_not_allowed(const std::string& argument, double value, const std::string& remedy) {
  char text[32];
  const char* const begin = text;
  const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
  return bad_argument(argument, '"' + std::string(begin, end) + "\" is not allowed", remedy);
}

}  // namespace pelt::text
