#pragma once

/// What verbs share that write their answers as lines of JSON: a header, a line for every frame,
/// the totals.

#include <pelt/math.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/colliders.hpp"

#include <nlohmann/json_fwd.hpp>

#include <fstream>
#include <ostream>
#include <span>
#include <string>

namespace pelt::tools {

/// --jsonl's file, standard output, or nothing.
class LineOutput {
 public:
  /// `path` may be kStandardOutput, or "" for nothing.
  Result<void> open(const std::string& path);

  /// Null where there is nothing to write to.
  std::ostream* stream() { return stream_; }

  /// Fails where any line is lost.
  Result<void> close();

 private:
  std::string path_;
  std::ofstream file_;
  std::ostream* stream_ = nullptr;
};

/// Where the words for people go: standard error if the lines take standard output.
std::ostream& words_beside(const std::string& jsonl);

/// The header without the options: `format`, `version`, `pelt`, `inputs`, `instances`.
nlohmann::ordered_json header_json(const char* format, const scenes::Scene& scene,
                                   std::span<const Collider> colliders);

nlohmann::ordered_json vector_json(const Vec3& v);

nlohmann::ordered_json counters_json(const QueryStats& work);

void write_line(const nlohmann::ordered_json& value, std::ostream& out);

}  // namespace pelt::tools
