#pragma once

/// The queries of `pelt check` for one frame.

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/check/check_question.hpp"
#include "tools/pelt/check/check_settings.hpp"
#include "tools/pelt/check/chord_deviation.hpp"
#include "tools/pelt/check/clearance_query.hpp"
#include "tools/pelt/check/contact_details.hpp"
#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/scene/self_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace pelt::tools::check {

/// What all threads of a check share. Immutable.
struct CheckPlan {
  /// All arguments must outlive the plan. `writes_lines`: frames have lines of --jsonl. Error
  /// messages name the file or the frame. Cost: with --self-always, that of the check itself.
  static Result<CheckPlan> make(const scene::StagedScene& staged, const CheckSettings& settings,
                                const CheckQuestion& question, bool writes_lines);

  scene::StagedScene staged;
  const CheckSettings& settings;
  const CheckQuestion& question;
  bool writes_lines = false;
  std::vector<std::uint32_t> frames;
  scenes::IgnoredPairs ignored;
  std::optional<scene::SelfFilters> filters;  ///< if bodies are tested against themselves
};

/// Queries single frames, in any order. Answers do not depend on the order.
class CheckQuery {
 public:
  /// `plan` must outlive the query. `threads`: of each query, at least 1.
  CheckQuery(const CheckPlan& plan, std::uint32_t threads);

  /// Replaces `answer` by that for a frame, given by its index in the plan. Error messages name the
  /// frame and the instance.
  Result<void> ask(std::size_t index, FrameAnswer& answer);

 private:
  using PairQuery = std::variant<scene::SceneQuery, ClearanceQuery, BudgetQuery>;

  static PairQuery make_pairs(const CheckPlan& plan, std::uint32_t threads);

  Result<void> ask_frame(std::size_t index, FrameAnswer& answer);
  Result<void> find_contacts(FrameAnswer& answer);
  Result<void> ask_inside(FrameAnswer& answer);
  Result<void> ask_between(std::size_t index, FrameAnswer& answer);
  Result<void> describe(FrameAnswer& answer);
  QueryStats work() const;

  const CheckPlan& plan_;
  PairQuery pairs_;
  std::optional<scene::SelfQuery> self_;
  std::optional<InsideQuery> inside_;
  std::optional<BetweenQuery> between_;
  std::optional<ChordDeviation> deviation_;  // of the steps
  std::optional<ContactDetails> details_;
  asset::SampleScratch sample_scratch_;
  scene::Palettes palettes_;         // of the frame
  scene::FrameContacts unfiltered_;  // of pairs, for --inside
};

}  // namespace pelt::tools::check
