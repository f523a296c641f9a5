#include "asset/message.hpp"

namespace pelt::asset {

Error with_remedy(const Error& error) {
  if (error.code != ErrorCode::malformed_file) return error;
  return malformed(error.message +
                   ": mend it in the program that wrote the file, and export it again");
}

std::string quoted(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  std::string text = "\"";
  for (const char c : name.substr(0, kLongest)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    text += control ? '?' : c;
  }
  return text + (name.size() > kLongest ? "...\"" : "\"");
}

std::string label(std::string_view kind, std::size_t index, std::string_view name) {
  std::string text = std::string(kind) + " " + std::to_string(index);
  return name.empty() ? text : text + " " + asset::quoted(name);
}

Error prefixed(std::string_view place, const Error& error) {
  return {error.code, std::string(place) + ": " + error.message};
}

}  // namespace pelt::asset
