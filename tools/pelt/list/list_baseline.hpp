#pragma once

/// The answer of an earlier check of a list of scenes, for `pelt check --scenes --baseline`.

#include <pelt/result.hpp>

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace pelt::tools::list {

class ListBaseline {
 public:
  /// Reads the output of `pelt check --scenes --jsonl`. Keeps the first and the last line of each
  /// scene.
  static Result<ListBaseline> read(const std::string& path);

  /// The first and the last line of the earlier check of a scene, as CheckBaseline::parse needs
  /// them. "" if the scene was not in the list, or could not be checked.
  std::string text_of(const std::string& scene) const;

  /// The scenes that only the earlier list has, in its order. Those that could not be checked are
  /// left out.
  std::vector<std::string> scenes_missing_in(std::span<const std::string> scenes) const;

 private:
  std::vector<std::string> scenes_;  // as JSON holds them
  std::unordered_map<std::string, std::string> texts_;
};

}  // namespace pelt::tools::list
