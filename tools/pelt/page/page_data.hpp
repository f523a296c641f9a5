#pragma once

/// Data of a scene for the viewer's page (viewer/README.md describes the format).

#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::page {

/// Results of `pelt check`, which the page compares with its own.
struct PageAnswer {
  std::vector<std::uint64_t> counts;  ///< contacts of each frame
  std::string lines;                  ///< the first line of --jsonl and the last
};

struct PageData {
  std::string command;               ///< the words that it was made by
  std::optional<PageAnswer> answer;  ///< nullopt: the page runs the queries itself
};

/// The data as JSON: the scene with all its files, how it is to be read, and what was found. Reads
/// the files again, and refuses those that have changed since the scene was read.
Result<std::string> page_data(const scenes::Scene& scene, const arguments::ModelArguments& models,
                              const PageData& data);

}  // namespace pelt::tools::page
