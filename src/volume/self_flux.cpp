/// The winding number in front of the surface, w, is known at one point of each connected part of
/// the surface (surface_winding.hpp). From there, it spreads over all edges. Where the outline of a
/// triangle passes another triangle, it changes by one.

#include "volume/flux.hpp"

#include "model/surface.hpp"
#include "model/triangle_places.hpp"
#include "pose/posed_tree.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_filter.hpp"
#include "self/self_tree.hpp"
#include "volume/perturbed_points.hpp"
#include "volume/surface_winding.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace pelt::detail {
namespace {

/// Self-collision leaves out pairs of triangles that touch only at surface vertices that they
/// share. If a surface vertex is split into vertices that can move apart, triangles with different
/// ones of these share it only because they are in the same position now.
class PairsAtCracks {
 public:
  PairsAtCracks(const PosedTree& posed, const Surface& surface, const Fans& fans,
                Stack<Contact>& pairs, QueryStats& work)
      : ids_(posed.tree.triangle_ids.data()),
        surface_(surface),
        fans_(fans),
        reader_s_(posed),
        reader_t_(posed),
        pairs_(pairs),
        work_(work) {}

  void add_all() {
    for (const FanRun& run : fans_.runs)
      for (std::uint32_t fan = run.first_fan; run.kind == FanKind::cracked && fan < run.end; ++fan)
        add(fans_[fan]);
  }

 private:
  void add(std::span<const FanTriangle> fan) {
    for (const FanTriangle& s : fan)
      for (const FanTriangle& t : fan)
        if (ids_[s.place()] < ids_[t.place()] && share_by_position(s.place(), t.place()))
          pairs_.push({ids_[s.place()], ids_[t.place()]});
  }

  /// Whether two triangles have different vertices of one surface vertex in the same position.
  bool share_by_position(std::uint32_t s, std::uint32_t t) {
    const TriangleCorners corners_s = reader_s_.corners(ids_[s], work_);
    const TriangleCorners corners_t = reader_t_.corners(ids_[t], work_);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (corners_s[i] == corners_t[k] && fans_.corners[s][i] == fans_.corners[t][k] &&
            surface_.corners[ids_[s]][i] != surface_.corners[ids_[t]][k])
          return true;
    return false;
  }

  const std::uint32_t* ids_;
  const Surface& surface_;
  const Fans& fans_;
  TriangleReader reader_s_, reader_t_;
  Stack<Contact>& pairs_;
  QueryStats& work_;
};

/// Writes pairs of triangles of one pose to `scratch.found`, each once, in ascending order.
/// Includes all pairs that intersect, apart from vertices that they share, after an infinitesimal
/// motion of the vertices. Opens all nodes.
///
/// `neighbours`: leaves out nothing.
QueryStats find_self_pairs(const PosedTree& posed, const Surface& surface,
                           const SelfFilter& neighbours, Scratch& scratch) {
  QueryStats work = self_collide_tree(posed, neighbours, nullptr, scratch,
                                      std::numeric_limits<std::uint32_t>::max());
  PairsAtCracks(posed, surface, neighbours.fans, scratch.found, work).add_all();
  sort_contacts(scratch.found, scratch.sorting);
  const Contact* const end = std::unique(scratch.found.begin(), scratch.found.end());
  scratch.found.shrink(static_cast<std::size_t>(end - scratch.found.begin()));
  return work;
}

// Computes the part of the flux of w through a surface that comes from the crossing of two of its
// triangles. w is the winding number of the surface in front of it.
//
// On a triangle (c, d, e), w jumps across the segments in which other triangles cross it. With the
// formulas of flux.hpp, the flux is the sum of
//
//     w(d) det(c, d, e)        where w(d) is that at the start of the edge de,
//     j (1 - t) det(c, d, e)   for each jump j on the edge de, at d + t (e - d), and
//     det(c, p, q)             for each segment pq.
//
// The first is added in self_flux.cpp.

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

/// Precondition, here and below: `crossing` is that of `a` and `b`.
Rounded crossing_flux(const SurfaceCrossing& crossing, const NumberedTriangle& a,
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

/// Returns how the winding number in front of a turns along its outline. `place`: of a.
OutlineTurns turns_of_a(const SurfaceCrossing& crossing, std::uint32_t place) {
  OutlineTurns turns = {place, {}};
  for (const SegmentEnd& end : crossing) add_end(end, end.a, end.turn_a, turns);
  return turns;
}

/// The same for b.
OutlineTurns turns_of_b(const SurfaceCrossing& crossing, std::uint32_t place) {
  OutlineTurns turns = {place, {}};
  for (const SegmentEnd& end : crossing) add_end(end, end.b, end.turn_b, turns);
  return turns;
}

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
    flux_ = flux_ + crossing_flux(*crossing, a, b, origin_);
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
