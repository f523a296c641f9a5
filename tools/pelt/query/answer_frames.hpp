#pragma once

/// Frame loop shared by the verbs that query scenes.

#include "asset/message.hpp"
#include "tools/pelt/output/line_output.hpp"
#include "tools/pelt/scene/scene_poses.hpp"

#include <optional>

namespace pelt::tools::query {

/// Has `query` ask in each frame (`ask(poses)`) and keep what all frames together need
/// (`keep(frame)`); `writer`, if there is one, tells its `answers()` of each frame (`frame`) and of
/// all (`totals`). Then closes `lines`.
template <typename Query, typename Writer>
Result<scene::FrameCosts> answer_frames(const scenes::Scene& scene,
                                        std::span<const scene::Collider> colliders,
                                        const arguments::FrameRange& frames, Query& query,
                                        std::optional<Writer>& writer, output::LineOutput& lines) {
  const auto ask = [&](std::span<Pose> poses) { return query.ask(poses); };
  const auto record = [&](std::uint32_t frame) {
    query.keep(frame);
    if (writer) writer->frame(frame, query.answers());
  };
  Result<scene::FrameCosts> costs = scene::run_frames(scene, colliders, frames, {ask, record});
  if (!costs) return asset::prefixed(scene.name, costs.error());
  if (writer) writer->totals(query.answers(), *costs);
  if (const auto closed = lines.close(); !closed) return closed.error();
  return costs;
}

}  // namespace pelt::tools::query
