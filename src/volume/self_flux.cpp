/// The winding number in front of the surface, w, is known at one point of each connected part of
/// the surface (front_winding.hpp). From there, it spreads over all edges. Where the outline of a
/// triangle passes another triangle, it changes by one.

#include "volume/self_flux.hpp"

#include "query/find_triangle.hpp"
#include "volume/flux.hpp"
#include "volume/front_winding.hpp"
#include "volume/numbered_triangle.hpp"
#include "volume/self_crossing_flux.hpp"
#include "volume/self_pairs.hpp"

#include <algorithm>
#include <span>

namespace pelt::detail {
namespace {

class SelfFlux {
 public:
  SelfFlux(const PosedTree& posed, const Surface& surface, Scratch& scratch, QueryStats& work)
      : posed_(posed),
        tree_(posed.tree),
        surface_(surface),
        spread_(spread_of(surface)),
        scratch_(scratch),
        work_(work) {}

  Rounded run() {
    work_ += find_self_pairs(posed_, surface_, spread_.neighbours, scratch_);
    origin_ = find_triangle(posed_, first_triangle(), work_).corners[0];
    scratch_.outline_turns.clear();
    TriangleReader reader_a(posed_), reader_b(posed_);
    for (const Contact& pair : scratch_.found) add_pair(pair, reader_a, reader_b);
    index_turns();
    spread();
    add_fronts();
    return flux_;
  }

 private:
  /// Near the intersections, where roundings are smallest.
  std::uint32_t first_triangle() const {
    return scratch_.found.empty() ? 0 : scratch_.found.begin()->triangle_a;
  }

  void add_pair(const Contact& pair, TriangleReader& reader_a, TriangleReader& reader_b) {
    const auto& [id_a, id_b] = pair;
    const Triangle &numbers_a = surface_.corners[id_a], &numbers_b = surface_.corners[id_b];
    if (has_repeated_vertex(numbers_a) || has_repeated_vertex(numbers_b)) return;
    ++work_.triangle_pairs;
    const NumberedTriangle a = numbered(reader_a.corners(id_a, work_), numbers_a);
    const NumberedTriangle b = numbered(reader_b.corners(id_b, work_), numbers_b);
    const auto crossing = cross_on_surface(a, b);
    if (!crossing) return;
    flux_ = flux_ + flux_of(*crossing, a, b, origin_);
    scratch_.outline_turns.push(turns_of_a(*crossing, tree_.triangle_places[id_a]));
    scratch_.outline_turns.push(turns_of_b(*crossing, tree_.triangle_places[id_b]));
  }

  /// Adds up the turns of each triangle.
  void index_turns() {
    Stack<OutlineTurns>& turns = scratch_.outline_turns;
    Stack<std::uint32_t>& turns_of = scratch_.turns_of;
    turns_of.assign(tree_.triangle_count(), 0);
    std::uint32_t count = 0;
    for (const OutlineTurns& turn : turns) {
      std::uint32_t& number = turns_of.begin()[turn.place];
      if (number == 0) {
        turns.begin()[count] = turn;
        number = ++count;
      } else {
        add(turn, turns.begin()[number - 1]);
      }
    }
    turns.shrink(count);
  }

  static void add(const OutlineTurns& turn, OutlineTurns& sum) {
    for (std::size_t i = 0; i < turn.after.size(); ++i) sum.after[i] += turn.after[i];
  }

  /// How much greater the winding number is at a point of the outline than at point 0.
  std::int32_t turn_at(std::uint32_t place, std::size_t point) const {
    const std::uint32_t number = scratch_.turns_of.begin()[place];
    return number == 0 ? 0 : scratch_.outline_turns.begin()[number - 1].at(point);
  }

  /// Writes the winding number at point 0 of each outline. On a common edge, the start of one
  /// triangle's edge is the end of the other's.
  void spread() {
    scratch_.fronts.assign(tree_.triangle_count(), 0);
    std::int32_t* const fronts = scratch_.fronts.begin();
    for (const SpreadingStep& step : spread_.steps)
      fronts[step.triangle] =
          step.is_first()
              ? front_winding(posed_, surface_, step.triangle, scratch_.nodes, work_)
              : fronts[step.from] + turn_at(step.from, std::size_t{2} * step.edge_from) -
                    turn_at(step.triangle, std::size_t{2} * step.edge + 1);
  }

  /// Adds the flux of each triangle as if the winding number were everywhere that of the start of
  /// edge 1.
  void add_fronts() {
    for (std::uint32_t index = 0; index < tree_.nodes.size(); ++index) {
      const Places places = places_of(tree_, tree_.nodes[index]);
      for (std::uint32_t place = places.first; place < places.end; ++place) {
        const std::int32_t front = scratch_.fronts.begin()[place] + turn_at(place, 2);
        if (front != 0) add_front(front, corners_at(tree_, place, *posed_.opened[index]));
      }
    }
  }

  void add_front(std::int32_t front, const TriangleCorners& corners) {
    flux_ = flux_ + Rounded(front) * flux_of(corners, origin_);
  }

  const PosedTree& posed_;
  const Tree& tree_;
  const Surface& surface_;
  const WindingSpread& spread_;
  Scratch& scratch_;
  QueryStats& work_;
  Vec3 origin_;
  Rounded flux_{0};
};

}  // namespace

Rounded self_flux(const PosedTree& posed, const Surface& surface, Scratch& scratch,
                  QueryStats& work) {
  return SelfFlux(posed, surface, scratch, work).run();
}

}  // namespace pelt::detail
