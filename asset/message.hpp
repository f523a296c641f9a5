#pragma once

/// The words in which the reader refuses a file.

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

/// An error with what is left to do about a file that breaks a rule of glTF: nothing here can mend
/// it. One of another kind is returned as it is.
Error with_remedy(const Error& error);

/// What is left to do about a file of another format.
inline constexpr const char* kExportGltf2 = ": export the character as glTF 2.0";

/// A name out of a file in quotes, as `printable_name` shows it.
std::string quoted(std::string_view name);

/// A thing of the file by number and, where it has one, name: `node 12 "Hips"`.
std::string label(std::string_view kind, std::size_t index, std::string_view name = {});

/// Puts the place before what went wrong there.
Error prefixed(std::string_view place, const Error& error);

}  // namespace pelt::asset
