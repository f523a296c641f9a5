#include "tools/pelt/summary.hpp"

#include "bench/statistics.hpp"
#include "tools/pelt/text.hpp"

#include <iomanip>

namespace pelt::tools {
namespace {

constexpr std::size_t kMostRows = 10;

std::ostream& label(std::ostream& out, const char* name) {
  return out << std::left << std::setw(10) << name << ' ';
}

std::uint64_t triangle_count(std::span<const Collider> colliders) {
  std::uint64_t count = 0;
  for (const Collider& collider : colliders) count += collider.model.triangle_count();
  return count;
}

/// "3-5, 9, 12-40": runs of frames in contact, where `stride` apart is next to each other.
std::string runs(std::span<const std::uint32_t> frames, std::uint32_t stride) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + stride) ++last;
    if (!text.empty()) text += ", ";
    text += std::to_string(frames[i]);
    if (last > i) text.append("-").append(std::to_string(frames[last]));
    i = last + 1;
  }
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest ? text : text.substr(0, text.rfind(',', kLongest)) + ", ...";
}

void print_contacts(const scenes::Scene& scene, const CheckSettings& settings,
                    const CheckReport& report, std::ostream& out) {
  const CheckTotals& totals = report.totals;
  if (totals.contacts == 0) {
    label(out, "contact") << "none in " << counted(totals.frames, "frame") << '\n';
    return;
  }
  label(out, "contact") << "in " << with_commas(totals.frames_in_contact) << " of "
                        << counted(totals.frames, "frame") << ": "
                        << runs(report.frames_in_contact, settings.frames.stride) << '\n';
  const double time = scenes::frame_time(scene, report.worst_frame);
  label(out, "worst") << "frame " << report.worst_frame << " (" << fixed(time, 3)
                      << " s): " << counted(report.worst_contacts, "contact") << '\n';
  label(out, "contacts") << with_commas(totals.contacts) << " in all"
                         << (settings.max_contacts ? ", cut short by the limit" : "") << '\n';
}

void print_rows(const char* title, const std::vector<TouchTally::Row>& rows, std::uint64_t contacts,
                std::ostream& out) {
  out << '\n' << title << '\n';
  std::size_t width = 0;
  for (const TouchTally::Row& row : rows) width = std::max(width, row.a.size());
  for (const TouchTally::Row& row : rows) {
    const double percent =
        100.0 * static_cast<double>(row.contacts) / static_cast<double>(contacts);
    out << std::right << std::setw(12) << with_commas(row.contacts) << std::setw(6)
        << fixed(percent, 1) << " %  " << std::left << std::setw(static_cast<int>(width)) << row.a
        << "  " << row.b << '\n';
  }
}

bool has_many_parts(const scenes::Scene& scene) {
  for (const scenes::Character& character : scene.characters) {
    if (character.asset.parts.size() > 1) return true;
  }
  return false;
}

/// Whoever forgot the other model should not read "none" as good news.
void print_too_few(const scenes::Scene& scene, const CheckSettings& settings, std::ostream& out) {
  const bool parts = settings.granularity == Granularity::part;
  label(out, "note") << "fewer than two " << (parts ? "parts" : "instances")
                     << ", so there is nothing to touch";
  if (!parts && has_many_parts(scene)) out << "; --by part checks the parts with each other";
  out << '\n';
}

void print_touching(const scenes::Scene& scene, const CheckReport& report, const TouchTally& tally,
                    std::ostream& out) {
  const std::uint64_t contacts = report.totals.contacts;
  if (contacts == 0) return;
  if (has_many_parts(scene)) {
    print_rows("parts that touch", tally.parts(kMostRows), contacts, out);
  }
  print_rows("joints that touch", tally.joints(kMostRows), contacts, out);
  out << '\n';
}

void print_work(const CheckReport& report, std::ostream& out) {
  const std::vector<double>& seconds = report.frame_seconds;
  label(out, "time") << "median " << fixed(1e3 * bench::median(seconds), 3) << " ms, mean "
                     << fixed(1e3 * bench::mean(seconds), 3) << " ms a frame\n";
  const QueryStats& work = report.totals.work;
  label(out, "work") << with_commas(work.node_pairs) << " node pairs, " << with_commas(work.refits)
                     << " refits, " << with_commas(work.posed_vertices) << " posed vertices, "
                     << with_commas(work.triangle_pairs) << " triangle pairs\n";
  if (report.totals.hash) label(out, "hash") << hex16(*report.totals.hash) << '\n';
}

}  // namespace

void print_summary(const scenes::Scene& scene, std::span<const Collider> colliders,
                   const CheckSettings& settings, const CheckReport& report,
                   const TouchTally& tally, std::ostream& out) {
  const bool parts = settings.granularity == Granularity::part;
  label(out, "scene") << scene.name << ": " << counted(scene.instances.size(), "instance");
  if (parts) out << ", " << counted(colliders.size(), "part");
  out << ", " << with_commas(triangle_count(colliders)) << " triangles\n";
  label(out, "method") << bench::name_of(settings.method) << '\n';
  if (colliders.size() < 2) print_too_few(scene, settings, out);
  print_contacts(scene, settings, report, out);
  print_touching(scene, report, tally, out);
  print_work(report, out);
}

}  // namespace pelt::tools
