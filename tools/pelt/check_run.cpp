#include "tools/pelt/check_run.hpp"

#include "asset/message.hpp"
#include "tools/pelt/clearance_query.hpp"
#include "tools/pelt/contact_hash.hpp"
#include "tools/pelt/ignored_contacts.hpp"
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
  report.frame_contacts.push_back(contacts);
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

/// What is done with the geometry of contacts, if it is asked for.
class Described {
 public:
  Described(const scenes::Scene& scene, std::span<const Collider> colliders)
      : details_(scene, colliders), tally_(scene, colliders) {}

  Result<void> add(std::uint32_t frame, const Palettes& palettes, const FrameContacts& found) {
    const Result<void> described = details_.describe(palettes, found);
    if (described) tally_.add(frame, found, details_);
    return described;
  }

  const ContactDetails& details() const { return details_; }

  void report(CheckReport& report) const {
    constexpr std::size_t kMostRows = 10;
    report.regions = tally_.regions();
    report.deepest = tally_.deepest(kMostRows);
  }

 private:
  ContactDetails details_;
  DepthTally tally_;
};

/// `Query` is SceneQuery or ClearanceQuery.
template <typename Query>
Result<CheckReport> run_query(Query& query, const scenes::Scene& scene,
                              std::span<const Collider> colliders, const CheckSettings& settings,
                              TouchTally& tally, JsonlWriter* jsonl) {
  const auto ignored = scenes::IgnoredPairs::make(scenes::characters_of(scene), settings.ignore);
  if (!ignored) return ignored.error();
  CheckReport report;
  report.worst_frame = settings.frames.begin;
  CollideOptions options;
  if (settings.max_contacts) options.max_contacts = *settings.max_contacts;
  asset::SampleScratch scratch;
  Palettes palettes;
  FrameContacts found;
  ContactHash hash;
  std::optional<Described> described;
  if (settings.describes_contacts) described.emplace(scene, colliders);
  std::optional<InsideQuery> inside;
  if (settings.asks_inside) {
    inside.emplace(scene, colliders);
    report.inside.emplace().closed_colliders = inside->closed_count();
  }
  const std::vector<std::uint32_t> frames = settings.frames.frames();
  Progress progress(frames.size());
  for (const std::uint32_t frame : frames) {
    sample_palettes(scene, frame, scratch, palettes);
    const Clock::time_point begin = Clock::now();
    const Result<void> posed = query.set_palettes(palettes);
    if (!posed) return asset::prefixed("frame " + std::to_string(frame), posed.error());
    query.collide(options, found);
    report.frame_seconds.push_back(seconds_since(begin));
    if (inside) {
      if (const auto asked = inside->ask(palettes, found); !asked) return asked.error();
      report.inside->add(frame, inside->pairs());
    }
    report.totals.ignored += take_ignored_out(*ignored, scene, colliders, found);
    count_frame(frame, found, report);
    tally.add(frame, found);
    hash.add(frame, found);
    if (described) {
      if (const auto added = described->add(frame, palettes, found); !added) return added.error();
    }
    const FrameExtras extras = {described ? &described->details() : nullptr,
                                inside ? &*inside : nullptr};
    if (jsonl != nullptr) jsonl->frame(frame, scenes::frame_time(scene, frame), found, extras);
    if (is_to_be_kept(frame, settings, report)) report.kept = {frame, found};
    progress.advance();
  }
  report.totals.work = query.work();
  if (inside) report.totals.work += inside->work();
  if (described) described->report(report);
  if (!settings.max_contacts) report.totals.hash = hash.value();
  const std::vector<Touch> touches = tally.touches();
  report.verdict =
      judge(scene, touches, settings.known ? &*settings.known : nullptr, settings.fail_on);
  if (jsonl != nullptr) jsonl->totals(report.totals, touches, report.verdict);
  return report;
}

}  // namespace

Result<CheckReport> run_check(const scenes::Scene& scene, std::span<const Collider> colliders,
                              const CheckSettings& settings, TouchTally& tally,
                              JsonlWriter* jsonl) {
  if (settings.clearance) {
    ClearanceQuery query(colliders, *settings.clearance);
    return run_query(query, scene, colliders, settings, tally, jsonl);
  }
  SceneQuery query(colliders, settings.method);
  return run_query(query, scene, colliders, settings, tally, jsonl);
}

}  // namespace pelt::tools
