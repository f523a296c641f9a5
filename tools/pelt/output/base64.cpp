#include "tools/pelt/output/base64.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::tools::output {

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t first = 0; first < bytes.size(); first += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8 |
              (first + i < bytes.size() ? static_cast<unsigned char>(bytes[first + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += first + i > bytes.size() ? '=' : kDigits[three >> (18 - 6 * i) & 63];
  }
  return text;
}

}  // namespace pelt::tools::output
