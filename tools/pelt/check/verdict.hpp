#pragma once

/// Whether a check has failed: on what was found, or on what is worse than in an earlier check.

#include "tools/pelt/check/check_baseline.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::check {

enum class FailOn {
  contact,  ///< any contact, and any body that is held whole
  grown,    ///< new touches or bodies, and touches with more contacts in their worst frame
  newly,    ///< new touches or contained bodies
  never,
};

/// Nothing for an unknown name.
std::optional<FailOn> find_fail_on(std::string_view name);
const char* name_of(FailOn fail_on);

/// Results of a check.
struct Findings {
  std::span<const Touch> touches;
  std::span<const Held> held;  ///< empty if not requested
};

/// A touch that is worse than it was.
struct Worse {
  Touch touch;
  std::uint64_t known = 0;  ///< contacts of its worst frame then; 0: it is new
};

/// A touch of the baseline that is none any more.
struct GoneTouch {
  CheckBaseline::TouchNames names;
  std::uint64_t known = 0;  ///< contacts of its worst frame then
};

/// Differences from a baseline.
struct Comparison {
  std::size_t known_touches = 0;  ///< how many the baseline has
  std::vector<Worse> worse;       ///< new ones first, of each kind those with most contacts
  std::vector<GoneTouch> gone;
  std::vector<GoneTouch> left_out;  ///< not asked: of parts that this check was told to leave out
  std::vector<Held> newly_held;
  std::vector<CheckBaseline::HeldNames> no_longer_held;
  std::vector<std::string> notes;  ///< how the earlier check differed from this one
};

Comparison compare(const scene::StagedScene& staged, const Findings& found,
                   const CheckBaseline& baseline);

struct Verdict {
  FailOn fail_on = FailOn::contact;
  bool is_failed = false;
  std::uint64_t pairs_compared = 0;      ///< of colliders, in each frame; 0: nothing was checked
  std::optional<Comparison> comparison;  ///< with a baseline
};

/// What a check is judged by.
struct Demand {
  FailOn fail_on = FailOn::contact;
  bool allows_empty = false;                ///< else a check that compares nothing has failed
  const CheckBaseline* baseline = nullptr;  ///< not null where `fail_on` asks for what was known
};

Verdict judge(const scene::StagedScene& staged, const Findings& found, const Demand& demand);

}  // namespace pelt::tools::check
