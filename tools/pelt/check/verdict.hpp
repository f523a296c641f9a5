#pragma once

/// Decides whether a check has failed, by its findings or by a comparison with an earlier check.

#include "tools/pelt/check/baseline.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::check {

struct CheckSettings;

enum class FailOn {
  contact,  ///< any contact, in frames or between them, and any contained body
  between,  ///< any contact between frames
  grown,    ///< new touches or bodies, and touches with more contacts in their worst frame
  newly,    ///< new touches or contained bodies
  unknown,  ///< like `contact`, and any undecided pair of bodies
  never,
};

/// Nullopt for an unknown name.
std::optional<FailOn> find_fail_on(std::string_view name);
const char* name_of(FailOn fail_on);

/// Results of a check.
struct Findings {
  const CheckTotals& totals;
  std::span<const Touch> touches;
  std::span<const Held> held;  ///< empty if not requested

  /// Touches between frames; empty if not requested.
  std::span<const Touch> between() const {
    return totals.between ? std::span<const Touch>(totals.between->touches)
                          : std::span<const Touch>();
  }
};

/// A touch that is worse than in the baseline.
struct Worse {
  Touch touch;
  std::uint64_t known = 0;  ///< contacts of its worst frame in the baseline; 0: new
};

/// A touch of the baseline that no longer exists.
struct GoneTouch {
  CheckBaseline::TouchNames names;
  std::uint64_t known = 0;  ///< contacts of its worst frame in the baseline
};

/// Differences of touches from those of a baseline.
struct TouchChanges {
  std::size_t known = 0;     ///< number of touches in the baseline
  std::vector<Worse> worse;  ///< new ones first; then by number of contacts
  std::vector<GoneTouch> gone;
  std::vector<GoneTouch> left_out;  ///< of parts that options leave out of this check
};

/// Differences from a baseline.
struct Comparison {
  TouchChanges touches;  ///< in frames
  TouchChanges between;  ///< between frames; contacts are those of the worst step
  std::vector<Held> newly_held;
  std::vector<CheckBaseline::HeldNames> no_longer_held;
  std::vector<std::string> notes;  ///< differences of the earlier check from this one
};

Comparison compare(const scene::StagedScene& staged, const Findings& found,
                   const CheckBaseline& baseline);

struct Verdict {
  FailOn fail_on = FailOn::contact;
  bool is_failed = false;
  /// Pairs of colliders, or of one with itself, in each frame. 0: nothing was checked.
  std::uint64_t pairs_compared = 0;
  std::optional<Comparison> comparison;  ///< with a baseline
};

Verdict judge(const scene::StagedScene& staged, const Findings& found,
              const CheckSettings& settings);

}  // namespace pelt::tools::check
