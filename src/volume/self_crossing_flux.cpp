#include "volume/self_crossing_flux.hpp"

#include "volume/flux.hpp"

namespace pelt::detail {
namespace {

TriangleCorners corners_of(const NumberedTriangle& t) { return {t[0].at, t[1].at, t[2].at}; }

/// An end of the segment that is on an edge of one triangle.
class EdgeEnd {
 public:
  EdgeEnd(const NumberedTriangle& own, std::uint8_t edge, std::int8_t turn,
          const NumberedTriangle& other)
      : own_(own),
        edge_(edge),
        turn_(turn),
        share_(perturbed_share(other, own[edge], own[(edge + 1) % 3])) {}

  RoundedVector position(const Vec3& origin) const {
    return divided(own_[edge_].at, own_[(edge_ + 1) % 3].at, share_, origin);
  }

  /// The flux of the jump.
  Rounded flux(const Vec3& origin) const {
    if (edge_ != 1) return Rounded(0);
    return Rounded(turn_) * (Rounded(1) - share_) * flux_of(corners_of(own_), origin);
  }

 private:
  const NumberedTriangle& own_;
  std::uint8_t edge_;
  std::int8_t turn_;
  Rounded share_;
};

EdgeEnd edge_end(const SegmentEnd& end, const NumberedTriangle& a, const NumberedTriangle& b) {
  return end.turn_a != 0 ? EdgeEnd(a, end.a, end.turn_a, b) : EdgeEnd(b, end.b, end.turn_b, a);
}

/// Adds a turn between two points of the outline, before point `next`, to all points after it.
void add_turn(std::int8_t turn, std::size_t next, OutlineTurns& turns) {
  for (std::size_t point = next; point <= turns.after.size(); ++point)
    turns.after[point - 1] += turn;
}

/// Adds the turn of one end. Point 0 comes after the turn at corner 0.
void add_end(const SegmentEnd& end, std::uint8_t feature, std::int8_t turn, OutlineTurns& turns) {
  if (!end.is_corner()) return add_turn(turn, std::size_t{2} * feature + 1, turns);
  if (feature != 0) add_turn(turn, std::size_t{2} * feature, turns);
}

}  // namespace

Rounded flux_of(const SurfaceCrossing& crossing, const NumberedTriangle& a,
                const NumberedTriangle& b, const Vec3& origin) {
  Rounded flux(0);
  const auto position = [&](const SegmentEnd& end) {
    if (end.is_corner()) return relative_to(origin, a[end.a].at);
    const EdgeEnd on_edge = edge_end(end, a, b);
    flux = flux + on_edge.flux(origin);
    return on_edge.position(origin);
  };
  const RoundedVector begin = position(crossing[0]), end = position(crossing[1]);
  return flux + dot(relative_to(b[0].at, a[0].at), cross(begin, end));
}

OutlineTurns turns_of_a(const SurfaceCrossing& crossing, std::uint32_t place) {
  OutlineTurns turns = {place, {}};
  for (const SegmentEnd& end : crossing) add_end(end, end.a, end.turn_a, turns);
  return turns;
}

OutlineTurns turns_of_b(const SurfaceCrossing& crossing, std::uint32_t place) {
  OutlineTurns turns = {place, {}};
  for (const SegmentEnd& end : crossing) add_end(end, end.b, end.turn_b, turns);
  return turns;
}

}  // namespace pelt::detail
