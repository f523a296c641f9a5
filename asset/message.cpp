#include "asset/message.hpp"

#include "asset/printable.hpp"

namespace pelt::asset {

Error with_remedy(const Error& error) {
  if (error.code != ErrorCode::malformed_file) return error;
  return malformed(error.message +
                   ": fix it in the program that wrote the file, and export it again");
}

std::string quoted(std::string_view name) { return '"' + printable_name(name) + '"'; }

std::string label(std::string_view kind, std::size_t index, std::string_view name) {
  std::string text = std::string(kind) + " " + std::to_string(index);
  return name.empty() ? text : text + " " + asset::quoted(name);
}

Error prefixed(std::string_view place, const Error& error) {
  return {error.code, std::string(place) + ": " + error.message};
}

}  // namespace pelt::asset
