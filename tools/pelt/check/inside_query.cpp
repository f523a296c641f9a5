#include "tools/pelt/check/inside_query.hpp"

#include "tools/pelt/check/surfaces.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pelt::tools::check {
namespace {

using Body = scenes::IgnoredPairs::Body;

Body body_of(const scenes::Scene& scene, const scene::Collider& collider) {
  return {scene.instances[collider.instance].character, collider.first_triangle,
          collider.model.triangle_count()};
}

/// [a][b] of all pairs. Instances of a character have the same answers.
std::vector<bool> find_ignored(const scenes::Scene& scene,
                               std::span<const scene::Collider> colliders,
                               const scenes::IgnoredPairs& ignored) {
  std::vector<bool> are_ignored;
  if (ignored.is_empty()) return are_ignored;
  std::map<std::pair<Body, Body>, bool> known;
  for (const scene::Collider& a : colliders)
    for (const scene::Collider& b : colliders) {
      const auto bodies = std::make_pair(body_of(scene, a), body_of(scene, b));
      const auto [answer, is_new] = known.try_emplace(bodies);
      if (is_new) answer->second = ignored.are_ignored(bodies.first, bodies.second);
      are_ignored.push_back(answer->second);
    }
  return are_ignored;
}

void add_held(std::uint32_t inner, std::uint32_t outer, std::uint32_t frame,
              std::vector<Held>& held) {
  const auto is_same = [&](const Held& h) { return h.inner == inner && h.outer == outer; };
  const auto known = std::find_if(held.begin(), held.end(), is_same);
  if (known == held.end())
    held.push_back({inner, outer, 1, frame});
  else
    ++known->frames;
}

}  // namespace

void InsideTally::add(std::uint32_t frame, std::span<const InsidePair> pairs) {
  bool is_held = false;
  for (const InsidePair& pair : pairs) {
    is_held |= pair.containment != Containment::none;
    if (pair.containment == Containment::a_in_b) add_held(pair.a, pair.b, frame, held);
    if (pair.containment == Containment::b_in_a) add_held(pair.b, pair.a, frame, held);
    if (pair.a_in_b.depth > deepest.depth) deepest = {pair.a_in_b.depth, pair.a, pair.b, frame};
    if (pair.b_in_a.depth > deepest.depth) deepest = {pair.b_in_a.depth, pair.b, pair.a, frame};
  }
  if (is_held) frames_held.push_back(frame);
}

InsideQuery::InsideQuery(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                         const scenes::IgnoredPairs& ignored)
    : colliders_(colliders),
      surfaces_(make_surfaces(scene, colliders)),
      is_ignored_(find_ignored(scene, colliders, ignored)),
      posed_(colliders) {}

Result<void> InsideQuery::ask(const scene::Palettes& palettes, const scene::FrameContacts& found) {
  pairs_.clear();
  if (const Result<void> taken = posed_.set_palettes(palettes); !taken) return taken;
  auto touching = found.pairs.begin();
  for (std::uint32_t a = 0; a < colliders_.size(); ++a)
    for (std::uint32_t b = a + 1; b < colliders_.size(); ++b) {
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
    pair.containment = containment(poses[a], surfaces_[a], poses[b], surfaces_[b], scratch_);
  }
  const bool is_inside = pair.containment != Containment::none;
  if (is_inside || pair.a_in_b.found() || pair.b_in_a.found()) pairs_.push_back(pair);
}

bool InsideQuery::is_ignored(std::uint32_t a, std::uint32_t b) const {
  return !is_ignored_.empty() && is_ignored_[a * colliders_.size() + b];
}

Penetration InsideQuery::deepest(std::uint32_t a, std::uint32_t b) {
  Penetration found;
  if (!surfaces_[b].is_closed()) return found;
  const std::span<Pose> poses = posed_.poses();
  work_ += deepest_vertex(poses[a], surfaces_[a], poses[b], surfaces_[b], scratch_, found);
  return found;
}

std::size_t InsideQuery::closed_count() const {
  return static_cast<std::size_t>(std::count_if(surfaces_.begin(), surfaces_.end(),
                                                [](const Surface& s) { return s.is_closed(); }));
}

}  // namespace pelt::tools::check
