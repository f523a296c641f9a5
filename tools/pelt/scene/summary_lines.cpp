#include "tools/pelt/scene/summary_lines.hpp"

#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <iomanip>

namespace pelt::tools::scene {
namespace {

std::uint64_t triangle_count(std::span<const Collider> colliders) {
  std::uint64_t count = 0;
  for (const Collider& collider : colliders) count += collider.model.triangle_count();
  return count;
}

constexpr std::size_t kLongestList = 200;

/// Truncates a list at a comma.
std::string shortened(const std::string& text) {
  if (text.size() <= kLongestList) return text;
  return text.substr(0, text.rfind(',', kLongestList)) + ", ...";
}

/// The clips of the takes with their values of --frames: "walk" 0:30, "idle" 30:60.
std::string take_list(std::span<const scenes::Take> takes) {
  std::string text;
  for (const scenes::Take& take : takes) {
    if (text.size() > kLongestList) break;
    if (!text.empty()) text += ", ";
    text.append(text::quoted(take.clip)).append(" ").append(std::to_string(take.first_frame));
    text.append(":").append(std::to_string(take.first_frame + take.frame_count));
  }
  return shortened(text);
}

/// "3-5, 9, 12-40": runs of ascending frames, which are printed less `first`.
std::string runs_from(std::uint32_t first, std::span<const std::uint32_t> frames,
                      std::uint32_t stride) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + stride) ++last;
    if (!text.empty()) text += ", ";
    text += std::to_string(frames[i] - first);
    if (last > i) text.append("-").append(std::to_string(frames[last] - first));
    i = last + 1;
  }
  return text;
}

}  // namespace

std::ostream& label(std::ostream& out, const char* name) {
  return out << std::left << std::setw(10) << name << ' ';
}

void print_scene(const StagedScene& staged, std::ostream& out) {
  label(out, "scene") << text::printable(staged.scene.name) << ": "
                      << text::counted(staged.scene.instances.size(), "instance");
  const bool parts = !staged.colliders.empty() && staged.colliders[0].part;
  if (parts) out << ", " << text::counted(staged.colliders.size(), "part");
  out << ", " << text::with_commas(triangle_count(staged.colliders)) << " triangles\n";
  if (const auto& takes = staged.scene.takes; !takes.empty())
    label(out, "clips") << text::with_commas(takes.size())
                        << "; --frames of each: " << take_list(takes) << '\n';
  for (const std::string& note : staged.scene.notes)
    label(out, "note") << text::printable(note) << '\n';
}

std::string clip_words(const scenes::Scene& scene, std::uint32_t frame) {
  const scenes::Take* take = scenes::find_take(scene, frame);
  return take == nullptr ? "" : " of clip " + text::quoted(take->clip);
}

std::string frame_words(const scenes::Scene& scene, std::uint32_t frame) {
  return "frame " + std::to_string(scenes::frame_in_take(scene, frame)) + clip_words(scene, frame);
}

bool has_many_parts(const scenes::Scene& scene) {
  for (const scenes::Character& character : scene.characters) {
    if (character.asset.parts.size() > 1) return true;
  }
  return false;
}

void print_too_few(const scenes::Scene& scene, Granularity granularity, std::ostream& out) {
  const bool parts = granularity == Granularity::part;
  label(out, "note") << "fewer than two " << (parts ? "parts" : "instances")
                     << ", so nothing can touch: none is tested against itself";
  if (!parts && has_many_parts(scene))
    out << "; --by part tests the parts against each other, but no part against itself";
  out << '\n';
}

std::string frame_runs(const scenes::Scene& scene, std::span<const std::uint32_t> frames,
                       std::uint32_t stride) {
  if (scene.takes.empty()) return shortened(runs_from(0, frames, stride));
  std::string text;
  while (!frames.empty() && text.size() <= kLongestList) {
    const scenes::Take& take = *scenes::find_take(scene, frames[0]);
    const auto end =
        std::lower_bound(frames.begin(), frames.end(), take.first_frame + take.frame_count);
    const auto count = static_cast<std::size_t>(end - frames.begin());
    text.append(text.empty() ? "" : ", ").append(text::quoted(take.clip)).append(" ");
    text.append(runs_from(take.first_frame, frames.first(count), stride));
    frames = frames.subspan(count);
  }
  return shortened(text);
}

void print_costs(std::span<const double> frame_seconds, const QueryStats& work, std::ostream& out) {
  const std::vector<double> seconds(frame_seconds.begin(), frame_seconds.end());
  label(out, "time") << "median " << text::fixed(1e3 * output::median(seconds), 3) << " ms, mean "
                     << text::fixed(1e3 * output::mean(seconds), 3) << " ms per frame\n";
  label(out, "work") << text::with_commas(work.node_pairs) << " node pairs, "
                     << text::with_commas(work.refits) << " refits, "
                     << text::with_commas(work.posed_vertices) << " posed vertices, "
                     << text::with_commas(work.triangle_pairs) << " triangle pairs";
  if (work.displacements > 0)
    out << ", " << text::with_commas(work.displacements) << " displacements";
  out << '\n';
}

std::string coordinates(const Vec3& v) {
  std::string text;
  for (const float x : {v.x, v.y, v.z}) {
    const std::string number = text::fixed(static_cast<double>(x), 3);
    text += std::string(number.size() < 9 ? 9 - number.size() : 1, ' ') + number;
  }
  return text;
}

}  // namespace pelt::tools::scene
