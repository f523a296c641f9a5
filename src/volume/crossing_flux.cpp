#include "volume/crossing_flux.hpp"

#include "volume/flux.hpp"

namespace pelt::detail {
namespace {

/// One end of the segment.
class End {
 public:
  End(const Piercing& piercing, const TriangleCorners& a, const TriangleCorners& b)
      : piercing_(piercing),
        own_(piercing.is_edge_of_a ? a : b),
        share_(share_of_edge(piercing, a, b)) {}

  RoundedVector position(const Vec3& origin) const {
    return divided(own_[piercing_.edge], own_[(piercing_.edge + 1) % 3], share_, origin);
  }

  /// The flux of the triangle whose edge jumps here.
  Rounded flux(const Vec3& origin) const {
    if (piercing_.edge == 2) return Rounded(0);
    const Rounded jump(piercing_.inwards), whole = jump * flux_of(own_, origin);
    return piercing_.edge == 0 ? whole : whole * (Rounded(1) - share_);
  }

  void add_to(WindingTurns& turns) const {
    if (piercing_.edge == 0) turns.to[0] += piercing_.inwards;
    if (piercing_.edge != 2) turns.to[1] += piercing_.inwards;
  }

 private:
  const Piercing& piercing_;
  const TriangleCorners& own_;
  Rounded share_;
};

}  // namespace

CrossingFlux flux_of(const GenericCrossing& crossing, const TriangleCorners& a,
                     const TriangleCorners& b, const Vec3& origin) {
  const End begin(crossing[0], a, b), end(crossing[1], a, b);
  CrossingFlux result;
  const RoundedVector between = RoundedVector(a[0]) - RoundedVector(b[0]);
  result.flux = dot(between, cross(begin.position(origin), end.position(origin))) +
                begin.flux(origin) + end.flux(origin);
  begin.add_to(crossing[0].is_edge_of_a ? result.turns_a : result.turns_b);
  end.add_to(crossing[1].is_edge_of_a ? result.turns_a : result.turns_b);
  return result;
}

}  // namespace pelt::detail
