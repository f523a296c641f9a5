#pragma once

/// Core of `pelt check`: finds the contacts of every frame of a scene.

#include "tools/pelt/check/always_tally.hpp"
#include "tools/pelt/check/check_settings.hpp"
#include "tools/pelt/check/inside_query.hpp"
#include "tools/pelt/check/jsonl.hpp"
#include "tools/pelt/check/patch_tally.hpp"
#include "tools/pelt/check/touch_tally.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>

namespace pelt::tools::check {

/// The share of frames that the summary suggests for --self-always.
inline constexpr double kSuggestedShare = 0.95;

struct CheckReport {
  /// The contacts of one frame, and its number.
  struct Kept {
    std::uint32_t frame = 0;
    scene::FrameContacts found;
  };

  CheckTotals totals;
  Verdict verdict;
  Kept kept;
  std::uint32_t worst_frame = 0;  ///< the first one with the most contacts
  std::uint64_t worst_contacts = 0;
  std::vector<std::uint32_t> frames_in_contact;
  std::vector<std::uint64_t> frame_contacts;  ///< per frame
  std::uint64_t patches = 0;                  ///< number of patches of described contacts
  std::vector<PatchTally::Row> longest_patches;
  std::optional<InsideTally> inside;   ///< if requested
  std::optional<AlwaysCounts> always;  ///< if --self-always is not chosen
  std::vector<double> frame_seconds;   ///< setting palettes and querying pairs, without sampling
};

/// Runs through the frames. Writes lines to `jsonl`, and prints only the progress
/// bar.
Result<CheckReport> run_check(const scene::StagedScene& staged, const CheckSettings& settings,
                              TouchTally& tally, JsonlWriter& jsonl);

}  // namespace pelt::tools::check
