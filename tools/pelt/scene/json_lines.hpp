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

/// The header without the options: `format`, `version`, `pelt`, `inputs`, `instances`.
nlohmann::ordered_json header_json(const char* format, const StagedScene& staged);

/// The start of a frame's line: `frame`, `clip` if the scene has takes, `time`.
nlohmann::ordered_json frame_json(const scenes::Scene& scene, std::uint32_t frame);

nlohmann::ordered_json vector_json(const Vec3& v);

nlohmann::ordered_json counters_json(const QueryStats& work);

/// The value that a reader of `write_line`'s output gets: names from files may be invalid UTF-8,
/// which JSON cannot contain.
nlohmann::json as_json_holds(const nlohmann::ordered_json& value);
std::string as_json_holds(const std::string& text);

void write_line(const nlohmann::ordered_json& value, std::ostream& out);

}  // namespace pelt::tools::scene
