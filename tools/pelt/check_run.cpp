#include "tools/pelt/check_run.hpp"

#include "asset/message.hpp"
#include "tools/pelt/contact_hash.hpp"
#include "tools/pelt/progress.hpp"

#include <chrono>

namespace pelt::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void count_frame(std::uint32_t frame, const FrameContacts& found, CheckReport& report) {
  const std::uint64_t contacts = found.contacts.size();
  ++report.totals.frames;
  report.totals.contacts += contacts;
  if (contacts == 0) return;
  ++report.totals.frames_in_contact;
  report.frames_in_contact.push_back(frame);
  if (contacts <= report.worst_contacts) return;
  report.worst_contacts = contacts;
  report.worst_frame = frame;
}

/// Whether this frame is the one to keep, as far as is known.
bool is_to_be_kept(std::uint32_t frame, const CheckSettings& settings, const CheckReport& report) {
  if (settings.frame_to_keep) return frame == *settings.frame_to_keep;
  return frame == settings.frames.begin ||
         (report.worst_contacts > 0 && frame == report.worst_frame);
}

}  // namespace

Result<CheckReport> run_check(const scenes::Scene& scene, std::span<const Collider> colliders,
                              const CheckSettings& settings, TouchTally& tally,
                              JsonlWriter* jsonl) {
  CheckReport report;
  report.worst_frame = settings.frames.begin;
  CollideOptions options;
  if (settings.max_contacts) options.max_contacts = *settings.max_contacts;
  SceneQuery query(colliders, settings.method);
  asset::SampleScratch scratch;
  Palettes palettes;
  FrameContacts found;
  ContactHash hash;
  const std::vector<std::uint32_t> frames = settings.frames.frames();
  Progress progress(frames.size());
  for (const std::uint32_t frame : frames) {
    sample_palettes(scene, frame, scratch, palettes);
    const Clock::time_point begin = Clock::now();
    const Result<void> posed = query.set_palettes(palettes);
    if (!posed) return asset::prefixed("frame " + std::to_string(frame), posed.error());
    query.collide(options, found);
    report.frame_seconds.push_back(seconds_since(begin));
    count_frame(frame, found, report);
    tally.add(found);
    hash.add(frame, found);
    if (jsonl != nullptr) jsonl->frame(frame, scenes::frame_time(scene, frame), found);
    if (is_to_be_kept(frame, settings, report)) report.kept = {frame, found};
    progress.advance();
  }
  report.totals.work = query.work();
  if (!settings.max_contacts) report.totals.hash = hash.value();
  if (jsonl != nullptr) jsonl->totals(report.totals);
  return report;
}

}  // namespace pelt::tools
