#pragma once

/// The viewer's page, and copies of it that show a scene.

#include "tools/pelt/page/page_data.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pelt::tools::page {

/// Possible locations of the page, the most specific first.
std::vector<std::filesystem::path> viewer_places();

/// The page as built, which opens with generated characters. Looks only at PELT_VIEWER if the
/// environment defines it, otherwise beside the installed command (share/pelt/viewer.html) and in
/// the build folder. Returns an error for the page of another version.
Result<std::string> read_viewer();

/// The page with this scene: self-contained, including all files.
Result<std::string> page_of_scene(const scenes::Scene& scene,
                                  const arguments::ModelArguments& models, const PageData& data);

}  // namespace pelt::tools::page
