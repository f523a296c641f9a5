#include "tools/pelt/check/between_query.hpp"

#include "scenes/takes.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pelt::tools::check {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether the contacts of a frame contain this one. O(log n) in pairs and contacts.
bool contains(const scene::FrameContacts& found, std::uint32_t a, std::uint32_t b,
              const Contact& contact) {
  const auto pair = std::lower_bound(
      found.pairs.begin(), found.pairs.end(), std::pair(a, b),
      [](const scene::FrameContacts::Pair& p, const std::pair<std::uint32_t, std::uint32_t>& key) {
        return std::pair(p.a, p.b) < key;
      });
  if (pair == found.pairs.end() || pair->a != a || pair->b != b) return false;
  const std::span<const Contact> contacts = found.of(*pair);
  return std::binary_search(contacts.begin(), contacts.end(), contact);
}

/// Appends a contact. Pairs of colliders ascend.
void append(std::uint32_t a, std::uint32_t b, const Contact& contact,
            scene::FrameContacts& contacts) {
  const std::size_t end = contacts.contacts.size();
  if (contacts.pairs.empty() || contacts.pairs.back().a != a || contacts.pairs.back().b != b)
    contacts.pairs.push_back({a, b, end, end});
  contacts.pairs.back().end = end + 1;
  contacts.contacts.push_back(contact);
}

}  // namespace

std::size_t StepContacts::earliest() const {
  const auto first = std::min_element(
      firsts.begin(), firsts.end(),
      [](const FirstTouch& x, const FirstTouch& y) { return x.seconds < y.seconds; });
  return static_cast<std::size_t>(first - firsts.begin());
}

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

Result<void> BetweenQuery::ask(std::uint32_t frame, const scene::Palettes& palettes,
                               const scene::FrameContacts& found) {
  is_in_step_ = frame_ && scenes::take_index(staged_.scene, *frame_) ==
                              scenes::take_index(staged_.scene, frame);
  if (is_in_step_) {
    if (const auto asked = ask_pieces(frame, palettes); !asked) return asked;
    sort_out(found);
  } else if (const auto posed = set_palettes(palettes); !posed) {
    return posed;
  }
  frame_ = frame;
  at_start_ = found;
  return {};
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

/// Finds the contacts of each piece. At the end, the crowd has the poses of `frame`.
Result<void> BetweenQuery::ask_pieces(std::uint32_t frame, const scene::Palettes& palettes) {
  step_.from = *frame_;
  step_.to = frame;
  found_.clear();
  seconds_ = 0;
  for (std::uint32_t piece = 0; piece < substeps_; ++piece) {
    const bool is_last = piece + 1 == substeps_;
    const double later = (frame - *frame_) * ((piece + 1.0) / substeps_);
    if (!is_last) sample_palettes(staged_.scene, {*frame_, later}, sample_scratch_, palettes_);
    const Clock::time_point begin = Clock::now();
    crowd_.begin_step();
    if (const auto posed = set_palettes(is_last ? palettes : palettes_); !posed) return posed;
    ask_piece(piece);
    seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
  }
  step_seconds_.push_back(seconds_);
  return {};
}

CrowdOptions BetweenQuery::tests() const {
  CrowdOptions options;
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
void BetweenQuery::ask_piece(std::uint32_t piece) {
  moving_.clear();
  work_ += crowd_.collide_moving(moving_, tests(), {.leave_out_start = true});
  if (!filters_of_parts_.empty()) filter_parts();
  for (const auto& [a, b, moving] : moving_) {
    const Contact contact =
        scene::numbered_in_assets(moving.contact, staged_.colliders[a], staged_.colliders[b]);
    if (ignored_.is_ignored(staged_.character_of(a), contact.triangle_a, staged_.character_of(b),
                            contact.triangle_b))
      continue;
    const double of_step = (piece + static_cast<double>(moving.time)) / substeps_;
    const double seconds =
        scenes::moment_time(staged_.scene, {step_.from, (step_.to - step_.from) * of_step});
    found_.push_back({a, b, contact, {seconds, of_step, moving.a, moving.b}});
  }
}

/// Sets the contacts of the step. What touches at the start of a piece has touched in the piece
/// before or at the start of the step, so `found_` and `at_start_` have all contacts.
void BetweenQuery::sort_out(const scene::FrameContacts& at_end) {
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Found& x, const Found& y) { return x.key() < y.key(); });
  const auto later = std::unique(found_.begin(), found_.end(),
                                 [](const Found& x, const Found& y) { return x.key() == y.key(); });
  found_.erase(later, found_.end());
  std::erase_if(found_, [&](const Found& f) { return contains(at_start_, f.a, f.b, f.contact); });
  step_.contacts = at_start_.contacts.size() + found_.size();
  step_.between.pairs.clear();
  step_.between.contacts.clear();
  step_.firsts.clear();
  for (const Found& found : found_) {
    if (contains(at_end, found.a, found.b, found.contact)) continue;
    append(found.a, found.b, found.contact, step_.between);
    step_.firsts.push_back(found.first);
  }
}

}  // namespace pelt::tools::check
