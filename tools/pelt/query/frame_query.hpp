#pragma once

/// Frame loop shared by the verbs that query scenes.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>

namespace pelt::tools::query {

/// A query, its results for the current frame and for all frames so far, and their output.
class FrameQuery {
 public:
  FrameQuery() = default;
  FrameQuery(const FrameQuery&) = delete;
  FrameQuery& operator=(const FrameQuery&) = delete;
  virtual ~FrameQuery() = default;

  /// Queries one frame. The frame loop times this call.
  virtual QueryStats ask(std::span<Pose> poses) = 0;

  /// Adds the results of this frame to the results of all frames.
  virtual void keep(std::uint32_t frame) = 0;

  /// Error if results were lost, for example because a temporary file could not be written. Checked
  /// after each line.
  virtual Result<void> status() const { return {}; }

  /// `format` of the JSON lines, such as "pelt-bounds".
  virtual const char* format() const = 0;

  /// `options` of the header, without `frames` and `fps`.
  virtual nlohmann::ordered_json options_json() const = 0;

  /// Writes the members of the current frame's line, except `frame` and `time`.
  virtual void write_frame(scene::JsonLine& line) const = 0;

  /// Writes the members of `totals`, except `frames`.
  virtual void write_totals(scene::JsonLine& line) const = 0;

  /// Prints the summary, which stands between the scene's lines and the costs.
  virtual void print(const arguments::FrameRange& frames, std::ostream& words) const = 0;
};

/// Runs `query` through the frames: writes the header, a line per frame and the totals, then prints
/// the summary. Error messages name the scene, the frame and the instance.
///
/// `jsonl`: path for the lines, as OutputFile::open expects it.
Result<void> run_frame_query(const scene::StagedScene& staged, const arguments::FrameRange& frames,
                             FrameQuery& query, const std::string& jsonl);

/// Opens the scene, makes its colliders, and runs a query of type `Query`, which is made of the
/// staged scene and `settings`.
template <typename Query, typename... Settings>
Result<arguments::ExitCode> run(const scene::QueryArguments& arguments,
                                scene::Granularity granularity, const Settings&... settings) {
  const Result<scene::QueryInput> input = scene::open_query(arguments);
  if (!input) return input.error();
  const auto colliders = scene::make_colliders(input->scene, granularity, arguments.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {input->scene, *colliders};
  Query query(staged, settings...);
  const auto answered = run_frame_query(staged, input->frames, query, arguments.jsonl);
  if (!answered) return answered.error();
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::query
