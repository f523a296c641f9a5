#pragma once

/// Adds up the answers of the frames of a check.

#include "tools/pelt/check/jsonl.hpp"
#include "tools/pelt/check/stage.hpp"
#include "tools/pelt/check/steps.hpp"
#include "tools/pelt/check/tallies.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"

#include <optional>
#include <span>
#include <vector>

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

/// Returns what `judge` needs. `report` and `touches` must outlive it.
Findings findings_of(const CheckReport& report, std::span<const Touch> touches);

class CheckRecord {
 public:
  /// All arguments must outlive the record. Precondition: `tally` is empty.
  CheckRecord(const Stage& stage, TouchTally& tally, JsonlWriter& jsonl);

  /// Adds the answer of a frame, and writes its lines. Call once for each frame, in order.
  void add(const FrameAnswer& answer);

  /// Judges the check and writes the last line. Precondition: all frames were added.
  Result<CheckReport> finish();

 private:
  void count(const FrameAnswer& answer);
  void count_unknown(const FrameAnswer& answer);
  Result<void> finish_extras();
  void judge_findings();

  const Stage& stage_;
  const CheckSettings& settings_;
  TouchTally& tally_;
  JsonlWriter& jsonl_;
  scene::ContactHash hash_;
  std::optional<AlwaysTally> always_;
  std::optional<InsideTally> inside_;
  std::optional<BetweenCheck> between_;
  PatchTally patches_;
  CheckReport report_;
};

}  // namespace pelt::tools::check
