#pragma once

/// Resolves a `uri` of a glTF file: embedded bytes, or a file beside the glTF file.

#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace pelt::asset {

bool is_data_uri(std::string_view uri);

/// The bytes of a data URI, in base64 or percent-encoded.
Result<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// Returns the path that a URI refers to, relative to the folder of the file that contains the URI,
/// wherever it leads; nothing for a data URI or an invalid percent code.
std::optional<std::filesystem::path> relative_file(std::string_view uri);

/// Returns the path of the file that a relative URI refers to inside `folder`. Rejects everything
/// else: other schemes, absolute paths, `..`, and links that leave the folder.
Result<std::filesystem::path> resolve_file_uri(std::string_view uri,
                                               const std::filesystem::path& folder);

}  // namespace pelt::asset
