#pragma once

/// The viewer: one HTML file with engine and page, into which data of a scene can be put.

#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/frame_range.hpp"
#include "tools/pelt/model_arguments.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools {

/// What `pelt check` has found, for the page to compare with what it finds.
struct PageAnswer {
  FrameRange frames;
  std::vector<std::uint64_t> counts;  ///< contacts of each of these frames
  std::optional<std::uint64_t> hash;
};

/// What a page shows (viewer/README.md has the format).
struct PageData {
  std::string command;  ///< the words that it was made by
  bool first_contact = false;
  std::optional<PageAnswer> answer;
};

/// The page as it was built: it opens with generated characters. Beside the command's installation
/// (share/pelt/viewer.html), where the environment's PELT_VIEWER says, or where the build left it.
Result<std::string> read_viewer();

/// The page that opens with this scene: self-contained, files and all.
Result<std::string> page_of_scene(const scenes::Scene& scene, const ModelArguments& models,
                                  const PageData& data);

}  // namespace pelt::tools
