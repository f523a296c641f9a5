#pragma once

/// Records and measures searches for `pelt bench --anytime`.
///
/// First, every search runs to its end in small slices, which are not timed: what it knows after a
/// share of its work is counted and does not depend on the machine. Then the time of a share is
/// measured: the instances are posed anew, so that no box or vertex is computed yet, and a search
/// that starts from there runs without a break until that share of its work is done. The time of a
/// share is the median of the repetitions. The methods take turns at every case.

#include "scenes/scene.hpp"
#include "tools/pelt/bench/anytime_curve.hpp"
#include "tools/pelt/bench/anytime_runner.hpp"

#include <functional>
#include <vector>

namespace pelt::tools::bench {

/// A scene whose frames are searched. Borrows its members.
struct AnytimeSubject {
  const scenes::Scene& scene;
  std::span<const scene::Collider> colliders;
  std::span<const std::uint32_t> frames;
};

/// What a method has found in all cases.
struct AnytimeRecord {
  std::vector<AnytimeCurve> curves;  ///< [cases]
  std::uint64_t hash = 0;            ///< of the contacts when complete, as of `collide`
};

/// The contacts of `collide` in the frames of a scene.
struct AnytimeTruth {
  std::vector<AnytimeCase> cases;
  std::uint64_t hash = 0;  ///< as in `pelt check`
};

Result<AnytimeTruth> find_cases(const AnytimeSubject& subject);

/// Runs a method to its end in each case. Times nothing.
Result<AnytimeRecord> record(const AnytimeSubject& subject, std::span<const AnytimeCase> cases,
                             const AnytimeBenchMethod& method);

/// Measures the times of all curves [methods] of `records`. Returns the time of `collide` for each
/// case, in microseconds. Calls `advance` after each case.
Result<std::vector<double>> measure_anytime(const AnytimeSubject& subject,
                                            std::span<const AnytimeCase> cases,
                                            std::span<const AnytimeBenchMethod> methods,
                                            std::uint32_t repetitions,
                                            std::span<AnytimeRecord> records,
                                            const std::function<void()>& advance);

}  // namespace pelt::tools::bench
