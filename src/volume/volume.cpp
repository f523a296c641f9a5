/// The queries for volumes.

#include <pelt/inside.hpp>

#include "base/assert.hpp"
#include "collide/collide_trees.hpp"
#include "model/surface.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/sort_contacts.hpp"
#include "self/fans.hpp"
#include "volume/flux.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace pelt {
namespace {

using detail::PosedTree;
using detail::Rounded;
using detail::WindingTurns;

Volume volume_of(const Rounded& flux) {
  const Rounded volume = flux / Rounded(6);
  return {volume.value(), volume.error()};
}

void push(detail::Stack<WindingTurns>& all, WindingTurns turns, std::uint32_t place) {
  turns.place = place;
  if (turns.to != std::array<std::int32_t, 2>()) all.push(turns);
}

void sort(detail::Stack<WindingTurns>& turns) {
  std::sort(turns.begin(), turns.end(),
            [](const WindingTurns& x, const WindingTurns& y) { return x.place < y.place; });
}

/// Sums what pairs of triangles contribute, and collects the turns of both bodies.
Rounded crossings_flux(const PosedTree& a, const PosedTree& b, const Vec3& origin,
                       detail::Scratch& scratch, QueryStats& work) {
  detail::TriangleReader triangles_a(a), triangles_b(b);
  Rounded flux(0);
  scratch.turns_a.clear();
  scratch.turns_b.clear();
  for (const auto& [id_a, id_b] : scratch.found) {
    ++work.triangle_pairs;
    const detail::TriangleCorners corners_a = triangles_a.corners(id_a, work);
    const detail::TriangleCorners corners_b = triangles_b.corners(id_b, work);
    const auto crossing = detail::cross_generic(corners_a, corners_b);
    if (!crossing) continue;
    const detail::CrossingFlux found = flux_of(*crossing, corners_a, corners_b, origin);
    flux = flux + found.flux;
    push(scratch.turns_a, found.turns_a, a.tree.triangle_places[id_a]);
    push(scratch.turns_b, found.turns_b, b.tree.triangle_places[id_b]);
  }
  sort(scratch.turns_a);
  sort(scratch.turns_b);
  return flux;
}

std::span<const WindingTurns> all(const detail::Stack<WindingTurns>& turns) {
  return {turns.begin(), turns.size()};
}

/// The first corner of a triangle of a. If the bodies intersect, the triangle is near the
/// intersection: roundings are smallest near the origin. Does not depend on earlier queries.
Vec3 origin_of(const PosedTree& a, const detail::Stack<Contact>& contacts, QueryStats& work) {
  const std::uint32_t triangle = contacts.empty() ? 0 : contacts.begin()->triangle_a;
  return detail::find_triangle(a, triangle, work).corners[0];
}

/// The flux of the product of both winding numbers.
Rounded product_flux(Pose& a, Pose& b, Scratch& scratch, QueryStats& work) {
  const PosedTree posed_a = a.detail().posed_tree(), posed_b = b.detail().posed_tree();
  detail::Scratch& memory = scratch.detail();
  work +=
      detail::collide_trees(posed_a, posed_b, memory, std::numeric_limits<std::uint32_t>::max());
  detail::sort_contacts(memory.found, memory.sorting);
  const Vec3 origin = origin_of(posed_a, memory.found, work);
  const Rounded crossings = crossings_flux(posed_a, posed_b, origin, memory, work);
  const detail::OtherSurface seen_from_a = {b, detail::kGenericDirection, all(memory.turns_a)};
  const detail::OtherSurface seen_from_b = {a, detail::kOppositeDirection, all(memory.turns_b)};
  return crossings + winding_flux(posed_a, seen_from_a, origin, scratch, work) +
         winding_flux(posed_b, seen_from_b, origin, scratch, work);
}

/// The flux of the winding number.
Rounded whole_flux(const PosedTree& posed, QueryStats& work) {
  detail::make_table(posed);
  work += detail::open_all(posed);
  return surface_flux(posed, detail::find_triangle(posed, 0, work).corners[0]);
}

}  // namespace

QueryStats volume(Pose& pose, Volume& result) {
  detail::require(detail::surface_of(pose).is_closed, "volume: the surface is not closed");
  QueryStats work;
  result = volume_of(whole_flux(pose.detail().posed_tree(), work));
  return work;
}

QueryStats self_intersection_volume(Pose& pose, Scratch& scratch, Volume& result) {
  const detail::Surface& surface = detail::surface_of(pose);
  detail::require(surface.is_closed, "self_intersection_volume: the surface is not closed");
  detail::require(pose.model().triangle_count() <= detail::kMaxFanTriangles,
                  "self_intersection_volume: the model has more than 2^28 triangles");
  QueryStats work;
  result = volume_of(self_flux(pose.detail().posed_tree(), surface, scratch.detail(), work));
  return work;
}

QueryStats intersection_volume(Pose& a, Pose& b, Scratch& scratch, Volume& result) {
  detail::require(&a != &b, "intersection_volume: `a` and `b` are the same pose; give two poses");
  detail::require(detail::surface_of(a).is_closed && detail::surface_of(b).is_closed,
                  "intersection_volume: a surface is not closed");
  QueryStats work;
  result = {};
  if (detail::begin_descent(a.detail().posed_tree(), b.detail().posed_tree(), work))
    result = volume_of(product_flux(a, b, scratch, work));
  return work;
}

}  // namespace pelt
