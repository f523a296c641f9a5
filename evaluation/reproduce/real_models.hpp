#pragma once

#include <filesystem>
#include <vector>

namespace pelt::reproduce {

/// The .glb files of a folder, sorted by name; empty if the folder does not exist.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

}  // namespace pelt::reproduce
