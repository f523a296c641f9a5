#pragma once

/// Output of `pelt check --jsonl`: a header, a line per frame, the totals.

#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/check/verdict.hpp"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <span>
#include <string>

namespace pelt::tools::check {

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

  /// Writes the last line.
  void totals(const Findings& found, const Verdict& verdict);

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
