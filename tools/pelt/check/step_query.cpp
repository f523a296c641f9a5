#include "tools/pelt/check/step_query.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>
#include <utility>

namespace pelt::tools::check {
namespace {

using Clock = std::chrono::steady_clock;

auto key_of(const FoundInStep& found) { return std::tie(found.a, found.b, found.contact); }

/// Sorts by colliders and triangles. Of equal pairs, the first one found stays.
void sort_out(std::vector<FoundInStep>& found) {
  std::stable_sort(found.begin(), found.end(), [](const FoundInStep& x, const FoundInStep& y) {
    return key_of(x) < key_of(y);
  });
  const auto later = std::unique(
      found.begin(), found.end(),
      [](const FoundInStep& x, const FoundInStep& y) { return key_of(x) == key_of(y); });
  found.erase(later, found.end());
}

/// Distance of `middle` from the middle of `begin` and `end`.
double distance_from_middle(const Vec3& begin, const Vec3& middle, const Vec3& end) {
  const auto along = [](float from, float at, float to) {
    return double{at} - (double{from} + double{to}) / 2;
  };
  const double x = along(begin.x, middle.x, end.x);
  const double y = along(begin.y, middle.y, end.y);
  const double z = along(begin.z, middle.z, end.z);
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

ChordDeviation::ChordDeviation(const scene::StagedScene& staged) : staged_(staged) {
  for (const scene::Collider& collider : staged.colliders) poses_.emplace_back(collider.model);
}

Result<Deviation> ChordDeviation::of_step(std::uint32_t from, std::uint32_t to,
                                          std::uint32_t substeps) {
  Deviation largest;
  largest.from = from;
  largest.to = to;
  std::uint32_t sampled = static_cast<std::uint32_t>(staged_.scene.instances.size());
  for (std::uint32_t c = 0; c < poses_.size(); ++c) {
    const std::uint32_t instance = staged_.colliders[c].instance;
    if (instance != std::exchange(sampled, instance)) sample(instance, largest, substeps);
    if (const auto measured = measure(c, largest); !measured)
      return scene::in_instance(instance, measured.error());
  }
  return largest;
}

void ChordDeviation::sample(std::uint32_t instance, const Deviation& step, std::uint32_t substeps) {
  halves_.resize(2 * std::size_t{substeps} + 1);
  for (std::size_t half = 0; half < halves_.size(); ++half) {
    const double later = (step.to - step.from) * (static_cast<double>(half) / (2.0 * substeps));
    sample_instance(staged_.scene, instance, {step.from, later}, scratch_, halves_[half]);
  }
}

/// Updates `largest` by the vertices of a collider. Precondition: its instance is sampled.
Result<void> ChordDeviation::measure(std::uint32_t collider, Deviation& largest) {
  const auto pose = [&](std::size_t half, std::vector<Vec3>& out) {
    return scene::pose_vertices(selection_.select(halves_[half], staged_.colliders[collider]),
                                poses_[collider], out);
  };
  if (const auto posed = pose(0, end_); !posed) return posed;
  for (std::size_t half = 2; half < halves_.size(); half += 2) {
    std::swap(begin_, end_);
    if (const auto posed = pose(half - 1, middle_); !posed) return posed;
    if (const auto posed = pose(half, end_); !posed) return posed;
    for (std::uint32_t v = 0; v < end_.size(); ++v) {
      const double distance = distance_from_middle(begin_[v], middle_[v], end_[v]);
      if (distance <= largest.distance) continue;
      largest.distance = distance;
      largest.collider = collider;
      largest.vertex = v;
    }
  }
  return {};
}

StepQuery::StepQuery(const Stage& stage, std::uint32_t threads)
    : stage_(stage),
      substeps_(*stage.settings.substeps),
      tests_{stage.settings.self.asks_pairs(), stage.filters},
      threads_(threads),
      deviation_(stage.staged),
      parted_(stage.colliders) {
  for (const scene::Collider& collider : stage.colliders) crowd_.add(collider.model);
}

Result<void> StepQuery::ask(std::uint32_t from, std::uint32_t to, const scene::Palettes& at_end,
                            StepAnswer& step) {
  step.from = from;
  step.to = to;
  step.found.clear();
  step.work = {};
  step.seconds = 0;
  if (const auto posed = pose_start(from); !posed) return posed;
  if (const auto asked = ask_pieces(at_end, step); !asked) return asked;
  posed_ = to;
  sort_out(step.found);
  const auto deviation = deviation_.of_step(from, to, substeps_);
  if (!deviation) return deviation.error();
  step.deviation = *deviation;
  return {};
}

/// Afterwards, no frame is known to be posed, because the poses change.
Result<void> StepQuery::pose_start(std::uint32_t frame) {
  if (std::exchange(posed_, std::nullopt) == frame) return {};
  sample_palettes(stage_.staged.scene, frame, sample_scratch_, palettes_);
  return set_palettes(palettes_);
}

Result<void> StepQuery::set_palettes(const scene::Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  for (std::uint32_t c = 0; c < stage_.staged.colliders.size(); ++c) {
    const scene::Collider& collider = stage_.staged.colliders[c];
    const auto posed = scene::set_pose(selection_.select(palettes, collider), crowd_, c);
    if (!posed) return scene::in_instance(collider.instance, posed.error());
  }
  return {};
}

/// Finds the contacts of each piece. At the end, the crowd has the poses of the end of the step.
Result<void> StepQuery::ask_pieces(const scene::Palettes& at_end, StepAnswer& step) {
  for (std::uint32_t piece = 0; piece < substeps_; ++piece) {
    const bool is_last = piece + 1 == substeps_;
    const double later = (step.to - step.from) * ((piece + 1.0) / substeps_);
    if (!is_last)
      sample_palettes(stage_.staged.scene, {step.from, later}, sample_scratch_, palettes_);
    const Clock::time_point begin = Clock::now();
    crowd_.begin_step();
    if (const auto posed = set_palettes(is_last ? at_end : palettes_); !posed) return posed;
    ask_piece(piece, step);
    step.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }
  return {};
}

/// Removes the contacts of parts of one instance that its filter drops. Parts are ordered by their
/// triangles, so that the order of the triangles of a contact stays.
void StepQuery::filter_parts() {
  auto kept = moving_.begin();
  for (auto begin = moving_.begin(); begin != moving_.end();) {
    const std::uint32_t a = begin->instance_a, b = begin->instance_b;
    const auto end = std::find_if(begin, moving_.end(), [&](const CrowdMovingContact& c) {
      return c.instance_a != a || c.instance_b != b;
    });
    const scene::Collider &of_a = stage_.staged.colliders[a], &of_b = stage_.staged.colliders[b];
    if (a == b || of_a.instance != of_b.instance) {
      kept = std::move(begin, end, kept);
      begin = end;
      continue;
    }
    kept_.clear();
    for (auto c = begin; c != end; ++c)
      kept_.push_back(scene::numbered_in_assets(c->moving.contact, of_a, of_b));
    leave_out(tests_.filters->of_parts.at(of_a.instance), scratch_, kept_);
    auto next = kept_.begin();
    for (; begin != end; ++begin)
      if (next != kept_.end() &&
          *next == scene::numbered_in_assets(begin->moving.contact, of_a, of_b)) {
        *kept++ = *begin;
        ++next;
      }
  }
  moving_.erase(kept, moving_.end());
}

/// Adds the contacts of a piece that count.
void StepQuery::ask_piece(std::uint32_t piece, StepAnswer& step) {
  moving_.clear();
  CrowdOptions options = tests_.crowd_options();
  options.threads = threads_;
  step.work += crowd_.collide(moving_, options, {.leave_out_start = true});
  if (tests_.filters && tests_.filters->need_all_of_pairs()) filter_parts();
  for (const auto& [a, b, moving] : moving_) {
    const Contact contact = scene::numbered_in_assets(moving.contact, stage_.staged.colliders[a],
                                                      stage_.staged.colliders[b]);
    if (stage_.ignored->is_ignored(stage_.staged.character_of(a), contact.triangle_a,
                                   stage_.staged.character_of(b), contact.triangle_b))
      continue;
    const double of_step = (piece + static_cast<double>(moving.time)) / substeps_;
    const double seconds =
        scenes::moment_time(stage_.staged.scene, {step.from, (step.to - step.from) * of_step});
    step.found.push_back({a, b, contact, {seconds, of_step, moving.a, moving.b}});
  }
}

}  // namespace pelt::tools::check
