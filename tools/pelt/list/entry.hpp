#pragma once

/// Files of lists of scenes: the list, and the answers of its scenes. An answer is an entry,
/// followed by the lines of the scene's check.

#include <pelt/result.hpp>

#include "tools/pelt/check/report.hpp"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace pelt::tools::list {

struct SceneEntry {
  std::string scene;                 ///< as in the list
  std::optional<std::string> error;  ///< why the scene could not be checked; all below is then 0
  std::uint64_t lines = 0;           ///< number of lines of `pelt check --jsonl` that follow
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t worst = 0;            ///< contacts of the worst frame
  std::uint32_t worst_frame = 0;      ///< meaningful if `worst` > 0
  bool is_failed = false;             ///< by --fail-on
  std::optional<std::uint64_t> hash;  ///< of the contacts; nullopt if they were limited
};

struct SceneAnswer {
  SceneEntry entry;
  std::string text;  ///< the line of the entry and its lines, with their ends
};

/// Precondition: `lines` are those of the check, with their ends.
SceneAnswer answer_of(const std::string& scene, const check::CheckReport& report,
                      const std::string& lines);

/// The answer of a scene that could not be checked.
SceneAnswer unchecked(const std::string& scene, const Error& error);

/// Reads a line with its end. False at the end of the file, and for a line that was cut.
bool read_line(std::istream& in, std::string& line);

/// Reads the line of an entry. Nullopt if it is none.
std::optional<SceneEntry> read_entry(const std::string& line);

/// Reads the lines that follow an entry. Nullopt if there are fewer.
std::optional<std::vector<std::string>> read_lines_of(const SceneEntry& entry, std::istream& in);

inline constexpr std::size_t kMostScenes = 10'000'000;

/// Reads the file of `pelt check --scenes`: the names of scenes or models, one per line, relative
/// to the current folder. Skips empty lines. Returns an error for a list that is empty or has a
/// name twice.
Result<std::vector<std::string>> read_scene_list(const std::string& path);

/// The answer of an earlier check of a list of scenes, for `pelt check --scenes --baseline`.
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
