#pragma once

/// Shared by verbs that write answers as lines of JSON: a header, a line per frame,
/// the totals.

#include <pelt/math.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <span>
#include <string>

namespace pelt::tools::scene {

/// Writes the header of an answer: `format`, `version`, `pelt`, `inputs`, `instances`, `options`.
void write_header(const char* format, const StagedScene& staged,
                  const nlohmann::ordered_json& options, std::ostream& out);

/// The start of a frame's line: `frame`; if the scene has takes, `clip` and `clip_frame`; `time`.
nlohmann::ordered_json frame_json(const scenes::Scene& scene, std::uint32_t frame);

/// Adds `frame` and, if the scene has takes, `clip` and `clip_frame`.
void add_frame(const scenes::Scene& scene, std::uint32_t frame, nlohmann::ordered_json& object);

/// Adds the frame as `key`, and its number within its take as `clip_key` if the scene has takes.
void add_frame(const scenes::Scene& scene, std::uint32_t frame, const char* key,
               const char* clip_key, nlohmann::ordered_json& object);

/// The frame with the most contacts: `frame`, `clip_frame` if the scene has takes, `contacts`.
nlohmann::ordered_json worst_json(const scenes::Scene& scene, std::uint32_t frame,
                                  std::uint64_t contacts);

nlohmann::ordered_json vector_json(const Vec3& v);

nlohmann::ordered_json counters_json(const QueryStats& work);

/// The value that a reader of `write_line`'s output gets: names from files may be invalid UTF-8,
/// which JSON cannot contain.
nlohmann::json as_json_holds(const nlohmann::ordered_json& value);
std::string as_json_holds(const std::string& text);

void write_line(const nlohmann::ordered_json& value, std::ostream& out);

/// A line of JSON that is written piece by piece, so that a long list is never in memory as a
/// whole. The text is that of `write_line` for the whole value.
class JsonLine {
 public:
  /// Begins an object. `out` must outlive this.
  explicit JsonLine(std::ostream& out);

  /// Adds the members of an object to the object that is open.
  void members(const nlohmann::ordered_json& object);

  void begin_object(const char* key);
  void end_object();

  void begin_list(const char* key);
  void item(const nlohmann::ordered_json& value);
  void end_list();

  /// Ends the object and the line.
  void end();

 private:
  void separate();
  void key(const std::string& name);
  void open(const char* name, char bracket);
  void close(char bracket);

  std::ostream& out_;
  bool is_first_ = true;  // of the object or the list that is open
};

}  // namespace pelt::tools::scene
