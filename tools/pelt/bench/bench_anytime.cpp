#include "tools/pelt/bench/bench_anytime.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_frames.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <set>

namespace pelt::tools::bench {
namespace {

/// Returns the records [methods], or an empty list if a complete search differs from `collide`.
Result<std::vector<AnytimeRecord>> record_all(const AnytimeSubject& subject,
                                              const AnytimeTruth& truth,
                                              const AnytimeSettings& settings,
                                              std::ostream& errors) {
  std::vector<AnytimeRecord> records;
  for (const AnytimeBenchMethod& method : settings.methods) {
    auto recorded = record(subject, truth.cases, method);
    if (!recorded) return recorded.error();
    if (recorded->hash != truth.hash) {
      errors << settings.program << ": internal error: " << asset::printable(subject.scene.name)
             << ": " << method.name << " gives the hash " << output::hex16(recorded->hash)
             << " when complete, collide gives " << output::hex16(truth.hash)
             << ": please report this with the scene\n";
      return std::vector<AnytimeRecord>();
    }
    records.push_back(std::move(*recorded));
  }
  return records;
}

std::size_t index_of_unit(const AnytimeSettings& settings) {
  const auto found =
      std::find_if(settings.methods.begin(), settings.methods.end(),
                   [](const auto& m) { return m.name == methods::kAnytimeContacts.name; });
  return static_cast<std::size_t>(found - settings.methods.begin());
}

/// Counts of the scene and its cases.
AnytimeSceneFigures counts_of(const AnytimeSubject& subject, const AnytimeTruth& truth) {
  AnytimeSceneFigures figures;
  figures.scene = subject.scene.name;
  figures.pairs = truth.cases.size();
  figures.hash = truth.hash;
  std::set<std::uint32_t> frames;
  for (const AnytimeCase& now : truth.cases) {
    frames.insert(now.frame);
    figures.contacts += now.contacts;
  }
  figures.frames = frames.size();
  for (const scene::Collider& collider : subject.colliders)
    figures.triangles += collider.model.triangle_count();
  return figures;
}

Result<AnytimeSceneFigures> measure_all(const AnytimeSubject& subject, const AnytimeTruth& truth,
                                        const AnytimeSettings& settings,
                                        std::vector<AnytimeRecord>& records) {
  output::Progress progress(truth.cases.size());
  const auto collide_us =
      measure_anytime(subject, truth.cases, settings.methods, settings.repetitions, records,
                      [&] { progress.advance(); });
  if (!collide_us) return collide_us.error();
  AnytimeSceneFigures figures = counts_of(subject, truth);
  figures.repetitions = settings.repetitions;
  figures.collide_us = output::mean(*collide_us);
  figures.methods = figures_of(settings.methods, records, index_of_unit(settings));
  return figures;
}

}  // namespace

Result<arguments::ExitCode> bench_anytime(const scenes::Scene& scene,
                                          const AnytimeSettings& settings,
                                          std::vector<AnytimeSceneFigures>& figures,
                                          std::ostream& errors) {
  if (const auto checked = require_two_instances(scene); !checked) return checked.error();
  const auto frames = choose_frames(scene, settings.frames);
  if (!frames) return frames.error();
  const auto colliders =
      scene::make_colliders(scene, scene::Granularity::instance, settings.models);
  if (!colliders) return colliders.error();
  const AnytimeSubject subject = {scene, *colliders, *frames};
  const auto truth = find_cases(subject);
  if (!truth) return truth.error();
  if (truth->cases.empty())
    return output::bad_argument(asset::printable(scene.name),
                                "has no contact in " + output::counted(frames->size(), "frame"),
                                "choose frames in contact with --frames");
  auto records = record_all(subject, *truth, settings, errors);
  if (!records) return records.error();
  if (records->empty()) return arguments::ExitCode::internal;
  auto measured = measure_all(subject, *truth, settings, *records);
  if (!measured) return measured.error();
  figures.push_back(std::move(*measured));
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::bench
