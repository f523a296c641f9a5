#pragma once

/// The viewer: one HTML file with engine and page, into which data of a scene can be put.

#include "tools/pelt/page/page_data.hpp"

#include <filesystem>
#include <vector>

namespace pelt::tools::page {

/// Possible locations of the page, the most specific first.
std::vector<std::filesystem::path> viewer_places();

/// The page as it was built: it opens with generated characters. Where the environment's
/// PELT_VIEWER says, and nowhere else if it says anything; else beside the command's installation
/// (share/pelt/viewer.html), or where the build left it. Refuses the page of another version.
Result<std::string> read_viewer();

/// The page that opens with this scene: self-contained, files and all.
Result<std::string> page_of_scene(const scenes::Scene& scene,
                                  const arguments::ModelArguments& models, const PageData& data);

}  // namespace pelt::tools::page
