#pragma once

/// The answer of one scene of a list: an entry, followed by the lines of its check.

#include <pelt/result.hpp>

#include "tools/pelt/check/check_record.hpp"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
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

/// Reads the line of an entry. Error messages have no place.
Result<SceneEntry> read_entry(const std::string& line);

/// Reads the lines that follow an entry. Nullopt if there are fewer.
std::optional<std::vector<std::string>> read_lines_of(const SceneEntry& entry, std::istream& in);

}  // namespace pelt::tools::list
