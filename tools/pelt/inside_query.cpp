#include "tools/pelt/inside_query.hpp"

#include "tools/pelt/surfaces.hpp"

#include <algorithm>

namespace pelt::tools {

void InsideTally::add(std::uint32_t frame, std::span<const InsidePair> pairs) {
  bool is_held = false;
  for (const InsidePair& pair : pairs) {
    is_held |= pair.containment != Containment::none;
    if (pair.a_in_b.depth > deepest.depth) deepest = {pair.a_in_b.depth, pair.a, pair.b, frame};
    if (pair.b_in_a.depth > deepest.depth) deepest = {pair.b_in_a.depth, pair.b, pair.a, frame};
  }
  if (is_held) frames_held.push_back(frame);
}

InsideQuery::InsideQuery(const scenes::Scene& scene, std::span<const Collider> colliders)
    : colliders_(colliders), surfaces_(make_surfaces(scene, colliders)), posed_(colliders) {}

Result<void> InsideQuery::ask(const Palettes& palettes, const FrameContacts& found) {
  pairs_.clear();
  if (const Result<void> taken = posed_.set_palettes(palettes); !taken) return taken;
  auto touching = found.pairs.begin();
  for (std::uint32_t a = 0; a < colliders_.size(); ++a)
    for (std::uint32_t b = a + 1; b < colliders_.size(); ++b) {
      const bool touches = touching != found.pairs.end() && touching->a == a && touching->b == b;
      if (touches) ++touching;
      ask_pair(a, b, touches);
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

}  // namespace pelt::tools
