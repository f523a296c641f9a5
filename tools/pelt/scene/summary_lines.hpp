#pragma once

/// Shared lines of the summaries of several verbs.

#include <pelt/math.hpp>
#include <pelt/query.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::scene {

/// The first column: the subject of the line.
std::ostream& label(std::ostream& out, const char* name);

/// Prints the scene, its instances and, if colliders are parts, its parts; triangles; the clips of
/// the scene's takes; its notes.
void print_scene(const StagedScene& staged, std::ostream& out);

bool has_many_parts(const scenes::Scene& scene);

/// ` of clip "walk"` for the clip of this frame's take, "" if the scene has no takes; printable.
std::string clip_words(const scenes::Scene& scene, std::uint32_t frame);

/// "frame 12", followed by `clip_words`. The frame is counted from the start of that clip's take.
std::string frame_words(const scenes::Scene& scene, std::uint32_t frame);

/// Says that nothing was tested, so that users who forgot the other model do not read "none" as a
/// clean result.
void print_too_few(const scenes::Scene& scene, Granularity granularity, std::ostream& out);

/// "3-5, 9, 12-40": runs of ascending frames; frames `stride` apart are consecutive. If the scene
/// has takes, frames are counted from the start of each take: "walk" 3-5, 9, "idle" 0-2.
std::string frame_runs(const scenes::Scene& scene, std::span<const std::uint32_t> frames,
                       std::uint32_t stride);

/// Three columns.
std::string coordinates(const Vec3& v);

/// Prints the time per frame and the work of all frames.
void print_costs(std::span<const double> frame_seconds, const QueryStats& work, std::ostream& out);

}  // namespace pelt::tools::scene
