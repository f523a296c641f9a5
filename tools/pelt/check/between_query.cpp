#include "tools/pelt/check/between_query.hpp"

#include "scenes/takes.hpp"

#include <algorithm>
#include <chrono>
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

}  // namespace

BetweenQuery::BetweenQuery(const scene::StagedScene& staged, std::uint32_t substeps,
                           const scenes::IgnoredPairs& ignored, const BetweenTests& tests)
    : staged_(staged),
      substeps_(substeps),
      ignored_(ignored),
      tests_(tests),
      parted_(staged.colliders) {
  for (const scene::Collider& collider : staged.colliders) crowd_.add(collider.model);
  if (tests.self == nullptr || tests.self->of_parts.empty()) return;
  std::size_t filter = 0;
  for (std::size_t c = 0; c < staged.colliders.size(); ++c) {
    const std::uint32_t instance = staged.colliders[c].instance;
    if (c > 0 && instance != staged.colliders[c - 1].instance) ++filter;
    filters_of_parts_.resize(instance + 1);
    filters_of_parts_[instance] = &tests.self->of_parts[filter];
  }
}

Result<void> BetweenQuery::ask(std::uint32_t from, std::uint32_t to, const scene::Palettes& at_end,
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
  return {};
}

/// Afterwards, no frame is known to be posed, because the poses change.
Result<void> BetweenQuery::pose_start(std::uint32_t frame) {
  if (std::exchange(posed_, std::nullopt) == frame) return {};
  sample_palettes(staged_.scene, frame, sample_scratch_, palettes_);
  return set_palettes(palettes_);
}

Result<void> BetweenQuery::set_palettes(const scene::Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  for (std::uint32_t c = 0; c < staged_.colliders.size(); ++c) {
    const scene::Collider& collider = staged_.colliders[c];
    const auto posed = scene::set_pose(selection_.select(palettes, collider), crowd_, c);
    if (!posed) return scene::in_instance(collider.instance, posed.error());
  }
  return {};
}

/// Finds the contacts of each piece. At the end, the crowd has the poses of the end of the step.
Result<void> BetweenQuery::ask_pieces(const scene::Palettes& at_end, StepAnswer& step) {
  for (std::uint32_t piece = 0; piece < substeps_; ++piece) {
    const bool is_last = piece + 1 == substeps_;
    const double later = (step.to - step.from) * ((piece + 1.0) / substeps_);
    if (!is_last) sample_palettes(staged_.scene, {step.from, later}, sample_scratch_, palettes_);
    const Clock::time_point begin = Clock::now();
    crowd_.begin_step();
    if (const auto posed = set_palettes(is_last ? at_end : palettes_); !posed) return posed;
    ask_piece(piece, step);
    step.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }
  return {};
}

CrowdOptions BetweenQuery::tests() const {
  CrowdOptions options;
  options.threads = tests_.threads;
  if (!tests_.pairs) options.filter = [](std::uint32_t, std::uint32_t) { return false; };
  if (tests_.self != nullptr)
    options.self_filter = [this](std::uint32_t c) { return &tests_.self->of_colliders[c]; };
  return options;
}

/// Removes the contacts of parts of one instance that its filter drops. Parts are ordered by their
/// triangles, so that the order of the triangles of a contact stays.
void BetweenQuery::filter_parts() {
  auto kept = moving_.begin();
  for (auto begin = moving_.begin(); begin != moving_.end();) {
    const std::uint32_t a = begin->instance_a, b = begin->instance_b;
    const auto end = std::find_if(begin, moving_.end(), [&](const CrowdMovingContact& c) {
      return c.instance_a != a || c.instance_b != b;
    });
    const scene::Collider &of_a = staged_.colliders[a], &of_b = staged_.colliders[b];
    if (a == b || of_a.instance != of_b.instance) {
      kept = std::move(begin, end, kept);
      begin = end;
      continue;
    }
    kept_.clear();
    for (auto c = begin; c != end; ++c)
      kept_.push_back(scene::numbered_in_assets(c->moving.contact, of_a, of_b));
    leave_out(*filters_of_parts_[of_a.instance], scratch_, kept_);
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
void BetweenQuery::ask_piece(std::uint32_t piece, StepAnswer& step) {
  moving_.clear();
  step.work += crowd_.collide(moving_, tests(), {.leave_out_start = true});
  if (!filters_of_parts_.empty()) filter_parts();
  for (const auto& [a, b, moving] : moving_) {
    const Contact contact =
        scene::numbered_in_assets(moving.contact, staged_.colliders[a], staged_.colliders[b]);
    if (ignored_.is_ignored(staged_.character_of(a), contact.triangle_a, staged_.character_of(b),
                            contact.triangle_b))
      continue;
    const double of_step = (piece + static_cast<double>(moving.time)) / substeps_;
    const double seconds =
        scenes::moment_time(staged_.scene, {step.from, (step.to - step.from) * of_step});
    step.found.push_back({a, b, contact, {seconds, of_step, moving.a, moving.b}});
  }
}

}  // namespace pelt::tools::check
