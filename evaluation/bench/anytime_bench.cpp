#include "evaluation/bench/anytime_bench.hpp"

#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/bench/measure.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace pelt::lab {
namespace {

namespace bench = tools::bench;
namespace output = tools::output;
using tools::bench::in_frame;
using tools::bench::Stopwatch;

/// The palettes of the frame of the last case.
class CasePalettes {
 public:
  explicit CasePalettes(const scenes::Scene& scene) : scene_(scene) {}

  const scene::Palettes& of(const AnytimeCase& now) {
    if (frame_ != now.frame) scene::sample_palettes(scene_, now.frame, scratch_, palettes_);
    frame_ = now.frame;
    return palettes_;
  }

 private:
  const scenes::Scene& scene_;
  std::optional<std::uint32_t> frame_;
  asset::SampleScratch scratch_;
  scene::Palettes palettes_;
};

/// Hash of the contacts of cases, which are added in order.
class CaseHash {
 public:
  /// Sorts the contacts.
  void add(const AnytimeCase& of, std::span<const Contact> contacts) {
    found_.pairs = {{of.a, of.b, 0, contacts.size()}};
    found_.contacts.assign(contacts.begin(), contacts.end());
    std::sort(found_.contacts.begin(), found_.contacts.end());
    hash_.add(of.frame, found_);
  }

  std::uint64_t value() const { return hash_.value(); }

 private:
  scene::FrameContacts found_;
  scene::ContactHash hash_;
};

/// Converts counts to shares.
class Shares {
 public:
  Shares(const AnytimeSubject& subject, const AnytimeCase& of)
      : contacts_(static_cast<double>(of.contacts)),
        pairs_(double{1} * subject.colliders[of.a].model.triangle_count() *
               subject.colliders[of.b].model.triangle_count()) {}

  AnytimePoint of(const Known& known) const {
    return {static_cast<double>(known.contacts) / contacts_,
            static_cast<double>(known.undecided_pairs) / pairs_, known.resolution};
  }

 private:
  double contacts_, pairs_;
};

/// Work after a share of the whole.
std::uint64_t work_after(double share, std::uint64_t whole) {
  return static_cast<std::uint64_t>(share * static_cast<double>(whole));
}

/// The work of a search that has been started, to its end.
std::uint64_t run_to_end(AnytimeMethod& method) {
  method.advance_to(std::numeric_limits<std::uint64_t>::max());
  return method.work_done();
}

AnytimeCurve curve_of(AnytimeMethod& method, const Shares& shares) {
  AnytimeCurve curve;
  curve.work = run_to_end(method);
  curve.longest_step = method.longest_step();
  method.restart();
  for (std::size_t i = 0; i <= kAnytimeSlices; ++i) {
    method.advance_to(work_after(static_cast<double>(i) / kAnytimeSlices, curve.work));
    curve.points[i] = shares.of(method.known());
  }
  return curve;
}

Result<double> time_of_share(AnytimeRunner& runner, const AnytimeCase& of,
                             const scene::Palettes& palettes, std::uint64_t work,
                             std::uint32_t repetitions) {
  std::vector<double> times;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    if (const auto posed = runner.pose(of, palettes); !posed) return posed.error();
    Stopwatch watch;
    runner.method().restart();
    runner.method().advance_to(work);
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return output::median(times);
}

Result<void> measure_curve(AnytimeRunner& runner, const AnytimeCase& of,
                           const scene::Palettes& palettes, std::uint32_t repetitions,
                           AnytimeCurve& curve) {
  if (const auto started = runner.start(of, palettes); !started) return started;
  run_to_end(runner.method());
  for (std::size_t i = 0; i < kTimedShares.size(); ++i) {
    const auto time =
        time_of_share(runner, of, palettes, work_after(kTimedShares[i], curve.work), repetitions);
    if (!time) return time.error();
    curve.times_us[i] = *time;
  }
  return {};
}

/// `collide`, which searches are compared with.
class Collide {
 public:
  explicit Collide(std::span<const scene::Collider> colliders)
      : colliders_(colliders), method_(methods::kOnDemand.make()) {
    for (const scene::Collider& collider : colliders_) method_->add(collider.model);
  }

  Result<void> pose(std::uint32_t body, const scene::Palettes& palettes) {
    const auto posed =
        scene::set_pose(selection_.select(palettes, colliders_[body]), *method_, body);
    return posed ? posed : scene::in_instance(colliders_[body].instance, posed.error());
  }

  const std::vector<Contact>& contacts(std::uint32_t a, std::uint32_t b) {
    contacts_.clear();
    method_->collide(a, b, contacts_, {});
    return contacts_;
  }

  /// The first run is not timed, because it finds the caches as other methods have left them.
  Result<double> time(const AnytimeCase& of, const scene::Palettes& palettes,
                      std::uint32_t repetitions) {
    std::vector<double> times;
    for (std::uint32_t r = 0; r <= repetitions; ++r) {
      for (const std::uint32_t body : {of.a, of.b})
        if (const auto posed = pose(body, palettes); !posed) return posed.error();
      Stopwatch watch;
      contacts(of.a, of.b);
      watch.stop();
      if (r > 0) times.push_back(watch.microseconds());
    }
    return output::median(times);
  }

 private:
  std::span<const scene::Collider> colliders_;
  scene::InputSelection selection_;
  std::unique_ptr<methods::Method> method_;
  std::vector<Contact> contacts_;
};

}  // namespace

AnytimeBenchMethod method_of(const AnytimeMethodKind& kind) {
  return {std::string(kind.name), std::string(kind.title), kind.make};
}

AnytimeRunner::AnytimeRunner(std::span<const scene::Collider> colliders,
                             const AnytimeBenchMethod& method)
    : colliders_(colliders), method_(method.make()) {
  for (const scene::Collider& collider : colliders_) method_->add(collider.model);
}

Result<void> AnytimeRunner::start(const AnytimeCase& of, const scene::Palettes& palettes) {
  method_->select(of.a, of.b);
  Result<void> posed = pose(of, palettes);
  if (posed) method_->restart();
  return posed;
}

Result<void> AnytimeRunner::pose(const AnytimeCase& of, const scene::Palettes& palettes) {
  for (const std::uint32_t body : {of.a, of.b}) {
    const auto posed =
        scene::set_pose(selection_.select(palettes, colliders_[body]), *method_, body);
    if (!posed) return scene::in_instance(colliders_[body].instance, posed.error());
  }
  return {};
}

Result<AnytimeTruth> find_cases(const AnytimeSubject& subject) {
  const auto count = static_cast<std::uint32_t>(subject.colliders.size());
  AnytimeTruth truth;
  CaseHash hash;
  Collide collide(subject.colliders);
  CasePalettes palettes(subject.scene);
  for (const std::uint32_t frame : subject.frames) {
    for (std::uint32_t body = 0; body < count; ++body)
      if (const auto posed = collide.pose(body, palettes.of({frame})); !posed)
        return in_frame(frame, posed.error());
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b) {
        const std::vector<Contact>& contacts = collide.contacts(a, b);
        if (contacts.empty()) continue;
        truth.cases.push_back({frame, a, b, contacts.size()});
        hash.add(truth.cases.back(), contacts);
      }
  }
  truth.hash = hash.value();
  return truth;
}

Result<AnytimeRecord> record(const AnytimeSubject& subject, std::span<const AnytimeCase> cases,
                             const AnytimeBenchMethod& method) {
  AnytimeRecord record = {method.name, method.title, {}, 0};
  CaseHash hash;
  AnytimeRunner runner(subject.colliders, method);
  CasePalettes palettes(subject.scene);
  for (const AnytimeCase& now : cases) {
    if (const auto started = runner.start(now, palettes.of(now)); !started)
      return in_frame(now.frame, started.error());
    record.curves.push_back(curve_of(runner.method(), Shares(subject, now)));
    hash.add(now, runner.method().contacts());
  }
  record.hash = hash.value();
  return record;
}

Result<std::vector<double>> measure_anytime(const AnytimeSubject& subject,
                                            std::span<const AnytimeCase> cases,
                                            std::span<const AnytimeBenchMethod> methods,
                                            std::uint32_t repetitions,
                                            std::span<AnytimeRecord> records,
                                            const std::function<void()>& advance) {
  std::vector<AnytimeRunner> runners;
  for (const AnytimeBenchMethod& method : methods) runners.emplace_back(subject.colliders, method);
  Collide collide(subject.colliders);
  CasePalettes palettes(subject.scene);
  std::vector<double> collide_us;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const scene::Palettes& now = palettes.of(cases[c]);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto measured =
          measure_curve(runners[m], cases[c], now, repetitions, records[m].curves[c]);
      if (!measured) return in_frame(cases[c].frame, measured.error());
    }
    const auto time = collide.time(cases[c], now, repetitions);
    if (!time) return in_frame(cases[c].frame, time.error());
    collide_us.push_back(*time);
    advance();
  }
  return collide_us;
}

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
      bench::print_disagreement(settings.program, subject.scene, method.name, recorded->hash,
                                " when complete", "collide", truth.hash, errors);
      return std::vector<AnytimeRecord>();
    }
    records.push_back(std::move(*recorded));
  }
  return records;
}

std::size_t index_of_unit(std::span<const AnytimeRecord> records) {
  const auto found = std::find_if(records.begin(), records.end(), [](const auto& record) {
    return record.method == kAnytimeContacts.name;
  });
  return static_cast<std::size_t>(found - records.begin());
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
  figures.methods = figures_of(records, index_of_unit(records));
  return figures;
}

}  // namespace

Result<std::optional<AnytimeSceneFigures>> bench_anytime(const scenes::Scene& scene,
                                                         const AnytimeSettings& settings,
                                                         std::ostream& errors) {
  if (const auto checked = bench::require_two_instances(scene); !checked) return checked.error();
  const auto frames = bench::choose_frames(scene, settings.frames);
  if (!frames) return frames.error();
  const auto colliders =
      scene::make_colliders(scene, scene::Granularity::instance, settings.models);
  if (!colliders) return colliders.error();
  const AnytimeSubject subject = {scene, *colliders, *frames};
  const auto truth = find_cases(subject);
  if (!truth) return truth.error();
  if (truth->cases.empty())
    return text::bad_argument(text::printable(scene.name),
                              "has no contact in " + text::counted(frames->size(), "frame"),
                              "choose frames in contact with --frames");
  auto records = record_all(subject, *truth, settings, errors);
  if (!records) return records.error();
  if (records->empty()) return std::optional<AnytimeSceneFigures>();
  auto measured = measure_all(subject, *truth, settings, *records);
  if (!measured) return measured.error();
  return std::optional(std::move(*measured));
}

}  // namespace pelt::lab
