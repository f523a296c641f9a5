#pragma once

/// Wording of the reader's errors.

#include <pelt/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace pelt::asset {

inline Error malformed(std::string message) {
  return {ErrorCode::malformed_file, std::move(message)};
}

inline Error unsupported(std::string message) {
  return {ErrorCode::unsupported, std::move(message)};
}

/// Adds the remedy for a file that violates the glTF format, which Pelt cannot repair. Returns
/// errors of other kinds unchanged.
Error with_remedy(const Error& error);

/// Remedy for a file of another format.
inline constexpr const char* kExportGltf2 = ": export the character as glTF 2.0";

/// Returns a name from a file in quotes, as shown by `printable_name`.
std::string quoted(std::string_view name);

/// Returns a label with the number and, if there is one, the name: `node 12 "Hips"`.
std::string label(std::string_view kind, std::size_t index, std::string_view name = {});

/// Prefixes the message of an error with the place of the error.
Error prefixed(std::string_view place, const Error& error);

}  // namespace pelt::asset
