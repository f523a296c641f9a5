#pragma once

/// Output of `pelt check --jsonl`: a header, a line per frame, the totals.

#include <pelt/self_filter.hpp>
#include <pelt/surface.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/check/steps.hpp"
#include "tools/pelt/check/verdict.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// Returns the line of a frame without its end. `geometry` describes the contacts of each pair of
/// the frame, unless empty.
std::string frame_line(const Stage& stage, const FrameAnswer& answer,
                       std::span<const ContactGeometry> geometry);

/// Returns the line of a step with contacts between its frames. `lists_triangles`: also all
/// contacts, with times and features.
nlohmann::ordered_json step_json(const scene::StagedScene& staged, const StepContacts& step,
                                 bool lists_triangles);

nlohmann::ordered_json left_out_json(const LeftOut& left_out);

/// A contact of a step, with its first time and the features that meet.
nlohmann::ordered_json first_touch_json(const Contact& contact, const FirstTouch& first);

/// Adds the frame from which a step starts, as `step`.
void add_step(const scenes::Scene& scene, std::uint32_t from, nlohmann::ordered_json& object);

/// Totals of the frames of a take.
struct TakeTotals {
  std::uint32_t take = 0;  ///< index into Scene::takes
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t worst = 0;        ///< the most contacts of one frame
  std::uint32_t worst_frame = 0;  ///< the first frame with as many
};

/// What --budget has left undecided.
struct UnknownTotals {
  std::vector<std::uint32_t> frames;  ///< frames with undecided pairs of bodies
  std::uint64_t most_pairs = 0;       ///< undecided pairs of triangles in one frame, the most
  double resolution = 0;              ///< longest side of all regions of missing contacts
};

struct CheckTotals {
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t ignored = 0;             ///< contacts that do not count
  LeftOut left_out;                      ///< contacts of bodies with themselves that do not count
  QueryStats work;                       ///< without that of steps
  std::optional<BetweenReport> between;  ///< if steps were tested
  std::vector<TakeTotals> takes;         ///< of checked frames; empty if the scene has no takes
  UnknownTotals unknown;
  std::optional<std::uint64_t> hash;  ///< nullopt if contacts were limited
};

/// Writes the lines of a check, or nothing if there is no stream.
class JsonlWriter {
 public:
  /// All arguments must outlive the writer.
  JsonlWriter(std::ostream* out, const Stage& stage) : out_(out), stage_(stage) {}

  void header();

  /// Whether lines are written.
  bool is_open() const { return out_ != nullptr; }

  /// Writes the line of a step with contacts between its frames, before that of its last frame.
  void step(const StepContacts& step);

  /// Writes the line of a frame.
  void frame(const FrameAnswer& answer);
  void totals(const CheckTotals& totals, const Findings& found, const Verdict& verdict);

 private:
  nlohmann::ordered_json held_list(std::span<const Held> held) const;
  using TouchJson = nlohmann::ordered_json(const scene::StagedScene& staged, const Touch& touch);
  void add_changes(const TouchChanges& changes, TouchJson* json_of,
                   nlohmann::ordered_json& json) const;
  nlohmann::ordered_json verdict_json(const Verdict& verdict) const;

  std::ostream* out_;
  const Stage& stage_;
};

}  // namespace pelt::tools::check
