#pragma once

/// The file of `pelt check --scenes`.

#include <pelt/result.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace pelt::tools::list {

inline constexpr std::size_t kMostScenes = 10'000'000;

/// Reads the names of scenes or models, one per line, relative to the current folder. Skips empty
/// lines. Returns an error for a list that is empty or has a name twice.
Result<std::vector<std::string>> read_scene_list(const std::string& path);

}  // namespace pelt::tools::list
