#include "tools/pelt/check/inside_query.hpp"

#include <utility>

namespace pelt::tools::check {
namespace {

using Body = scenes::IgnoredPairs::Body;

Body body_of(const scene::StagedScene& staged, std::uint32_t collider) {
  const scene::Collider& body = staged.colliders[collider];
  return {staged.character_of(collider), body.first_triangle, body.model.triangle_count()};
}

}  // namespace

void InsideTally::add(std::uint32_t frame, std::span<const InsidePair> pairs, std::uint32_t take) {
  if (take != take_) held_at_.clear();
  take_ = take;
  bool is_held = false;
  for (const InsidePair& pair : pairs) {
    is_held |= pair.containment != Containment::none;
    if (pair.containment == Containment::a_in_b) add_held(pair.a, pair.b, frame);
    if (pair.containment == Containment::b_in_a) add_held(pair.b, pair.a, frame);
    if (pair.a_in_b.depth > deepest.depth) deepest = {pair.a_in_b.depth, pair.a, pair.b, frame};
    if (pair.b_in_a.depth > deepest.depth) deepest = {pair.b_in_a.depth, pair.b, pair.a, frame};
  }
  if (is_held) frames_held.push_back(frame);
}

void InsideTally::add_held(std::uint32_t inner, std::uint32_t outer, std::uint32_t frame) {
  const std::uint64_t key = std::uint64_t{inner} << 32 | outer;
  const auto [known, is_new] = held_at_.try_emplace(key, held.size());
  if (is_new)
    held.push_back({inner, outer, 1, frame, take_});
  else
    ++held[known->second].frames;
}

InsideQuery::InsideQuery(const scene::StagedScene& staged, const scenes::IgnoredPairs& ignored)
    : staged_(staged), ignored_(ignored), posed_(staged.colliders) {}

Result<void> InsideQuery::ask(const scene::Palettes& palettes, const scene::FrameContacts& found) {
  pairs_.clear();
  if (const Result<void> taken = posed_.set_palettes(palettes); !taken) return taken;
  auto touching = found.pairs.begin();
  for (const auto& [a, b] : near_pairs_.find(posed_.poses(), 0)) {
    while (touching != found.pairs.end() && touching->a == touching->b) ++touching;
    const bool touches = touching != found.pairs.end() && touching->a == a && touching->b == b;
    if (touches) ++touching;
    if (!is_ignored(a, b)) ask_pair(a, b, touches);
  }
  return {};
}

void InsideQuery::ask_pair(std::uint32_t a, std::uint32_t b, bool touches) {
  InsidePair pair = {.a = a, .b = b};
  if (touches) {
    pair.a_in_b = deepest(a, b);
    pair.b_in_a = deepest(b, a);
  } else {
    const std::span<Pose> poses = posed_.poses();
    work_ += containment(poses[a], poses[b], scratch_, pair.containment);
  }
  const bool is_inside = pair.containment != Containment::none;
  if (is_inside || pair.a_in_b || pair.b_in_a) pairs_.push_back(pair);
}

/// Cached by character, because all instances of a character have the same answer.
bool InsideQuery::is_ignored(std::uint32_t a, std::uint32_t b) {
  if (ignored_.is_empty()) return false;
  const Bodies bodies = {body_of(staged_, a), body_of(staged_, b)};
  const auto [known, is_new] = are_ignored_.try_emplace(bodies);
  if (is_new) known->second = ignored_.are_ignored(bodies.first, bodies.second);
  return known->second;
}

Penetration InsideQuery::deepest(std::uint32_t a, std::uint32_t b) {
  Penetration found;
  const std::span<Pose> poses = posed_.poses();
  if (!poses[b].model().surface().is_closed()) return found;
  work_ += deepest_vertex(poses[a], poses[b], scratch_, found);
  return found;
}

}  // namespace pelt::tools::check
