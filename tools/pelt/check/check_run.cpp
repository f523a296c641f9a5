#include "tools/pelt/check/check_run.hpp"

#include "tools/pelt/check/ask_frames.hpp"

namespace pelt::tools::check {
namespace {

Result<void> ask_all(const scene::StagedScene& staged, const CheckSettings& settings,
                     const CheckQuestion& question, bool writes_lines, const UseAnswer& use) {
  const auto plan = CheckPlan::make(staged, settings, question, writes_lines);
  if (!plan) return plan.error();
  return ask_frames(*plan, {0, plan->frames.size()}, settings.threads, use);
}

}  // namespace

Result<CheckReport> run_check(const scene::StagedScene& staged, const CheckSettings& settings,
                              const CheckQuestion& question, const FrameSource& source,
                              TouchTally& tally, JsonlWriter& jsonl) {
  CheckRecord record(staged, settings, tally, jsonl);
  const auto add = [&](const FrameAnswer& answer) -> Result<void> {
    record.add(answer);
    return {};
  };
  const auto added = source ? source(staged, settings, add)
                            : ask_all(staged, settings, question, jsonl.is_open(), add);
  if (!added) return added.error();
  return record.finish();
}

}  // namespace pelt::tools::check
