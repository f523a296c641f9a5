#pragma once

#include <filesystem>
#include <vector>

namespace pelt::reproduce {

/// The .glb files of a folder, by name; none where there is no folder.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

}  // namespace pelt::reproduce
