#pragma once

#include <filesystem>
#include <vector>

namespace pelt::asset {

/// The files that the file at `path` names by a `uri`: buffers and images, whether Pelt reads them
/// or not, and whether they exist or not. Empty if the file is no glTF. Reads no more of a .glb
/// than its JSON text.
std::vector<std::filesystem::path> referenced_files(const std::filesystem::path& path);

}  // namespace pelt::asset
