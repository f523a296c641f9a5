#pragma once

/// Frame loop shared by the verbs that query scenes.

#include "tools/pelt/scene/json_lines.hpp"
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

  /// Prints the summary, which stands between the scene's lines and the costs. `frames` is the
  /// number of frames.
  virtual void print(std::size_t frames, std::ostream& words) const = 0;
};

/// Destinations of the results of a query.
struct QueryOutputs {
  std::string jsonl;    ///< path, as OutputFile::open expects it
  std::ostream& words;  ///< the summary
};

/// Runs `query` through the frames: writes the header, a line per frame and the totals, then prints
/// the summary. Error messages name the scene, the frame and the instance.
Result<void> run_frame_query(const scene::StagedScene& staged, const arguments::FrameRange& frames,
                             FrameQuery& query, const QueryOutputs& outputs);

}  // namespace pelt::tools::query
