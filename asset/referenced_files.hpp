#pragma once

#include <filesystem>
#include <vector>

namespace pelt::asset {

/// The files that the file at `path` refers to by a `uri`: buffers and images, whether or not Pelt
/// reads them, and whether or not they exist. Empty if the file is not a glTF file. Of a .glb file,
/// reads only the JSON text.
std::vector<std::filesystem::path> referenced_files(const std::filesystem::path& path);

}  // namespace pelt::asset
