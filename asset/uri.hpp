#pragma once

/// What a `uri` of a glTF file stands for: bytes written into it, or a file beside it.

#include <pelt/result.hpp>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace pelt::asset {

bool is_data_uri(std::string_view uri);

/// The bytes of a data URI, in base64 or percent-encoded.
Result<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// The file that a relative URI names inside `folder`. Refuses everything else: other schemes,
/// absolute paths, `..`, and links that lead out of the folder.
Result<std::filesystem::path> resolve_file_uri(std::string_view uri,
                                               const std::filesystem::path& folder);

}  // namespace pelt::asset
