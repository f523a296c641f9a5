#pragma once

/// URIs, and the files that a model refers to by them.

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

/// The files that the file at `path` refers to by a `uri`: buffers and images, whether or not Pelt
/// reads them, and whether or not they exist. Empty if the file is not a glTF file. Of a .glb file,
/// reads only the JSON text.
std::vector<std::filesystem::path> referenced_files(const std::filesystem::path& path);

}  // namespace pelt::asset
