#include "tools/pelt/query/frame_query.hpp"

#include "text/message.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Writes the JSON lines of a query, or nothing if there is no stream.
class QueryLines {
 public:
  QueryLines(const scene::StagedScene& staged, const FrameQuery& query, std::ostream* out)
      : staged_(staged), query_(query), out_(out) {}

  void header(const arguments::FrameRange& frames) {
    if (out_ == nullptr) return;
    ordered_json options = query_.options_json();
    options["frames"] = {frames.begin, frames.end, frames.stride};
    options["fps"] = staged_.scene.fps;
    scene::write_header(query_.format(), staged_, options, *out_);
  }

  void frame(std::uint32_t frame) {
    if (out_ == nullptr) return;
    scene::JsonLine line(*out_);
    line.members(scene::frame_json(staged_.scene, frame));
    query_.write_frame(line);
    line.end();
  }

  void totals(const scene::FrameCosts& costs) {
    if (out_ == nullptr) return;
    scene::JsonLine line(*out_);
    line.begin_object("totals");
    line.members({{"frames", costs.seconds.size()}});
    query_.write_totals(line);
    line.end_object();
    line.members({{"counters", scene::counters_json(costs.work)}});
    line.end();
  }

 private:
  scene::StagedScene staged_;
  const FrameQuery& query_;
  std::ostream* out_;
};

Result<scene::FrameCosts> ask_frames(const scene::StagedScene& staged,
                                     const arguments::FrameRange& frames, FrameQuery& query,
                                     QueryLines& lines) {
  scene::ScenePoses posed(staged.colliders);
  const auto ask = [&](const scene::Palettes& palettes) -> Result<QueryStats> {
    if (const auto taken = posed.set_palettes(palettes); !taken) return taken.error();
    return query.ask(posed.poses());
  };
  const auto record = [&](std::uint32_t frame, const scene::Palettes&) -> Result<void> {
    query.keep(frame);
    lines.frame(frame);
    return query.status();
  };
  return scene::run_frames(staged.scene, frames, {ask, record});
}

}  // namespace

Result<void> run_frame_query(const scene::StagedScene& staged, const arguments::FrameRange& frames,
                             FrameQuery& query, const std::string& jsonl) {
  output::OutputFile file;
  if (const auto opened = file.open(jsonl); !opened) return opened.error();
  QueryLines lines(staged, query, file.stream());
  lines.header(frames);
  const Result<scene::FrameCosts> costs = ask_frames(staged, frames, query, lines);
  if (!costs) return text::prefixed(staged.scene.name, costs.error());
  lines.totals(*costs);
  if (const auto stored = query.status(); !stored) return stored.error();
  if (const auto closed = file.close(); !closed) return closed.error();
  std::ostream& words = output::words_beside({jsonl});
  scene::print_scene(staged, words);
  query.print(frames, words);
  scene::print_costs(costs->seconds, costs->work, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
