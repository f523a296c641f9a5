#pragma once

/// The answer of an earlier check of a list of scenes, for `pelt check --scenes --baseline`.

#include <pelt/result.hpp>

#include <string>
#include <unordered_map>

namespace pelt::tools::list {

class ListBaseline {
 public:
  /// Reads the output of `pelt check --scenes --jsonl`. Keeps the first and the last line of each
  /// scene.
  static Result<ListBaseline> read(const std::string& path);

  /// The first and the last line of the earlier check of a scene, as CheckBaseline::parse needs
  /// them. "" if the scene was not in the list, or could not be checked.
  std::string text_of(const std::string& scene) const;

 private:
  std::unordered_map<std::string, std::string> texts_;
};

}  // namespace pelt::tools::list
