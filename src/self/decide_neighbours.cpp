#include "self/decide_neighbours.hpp"

#include "motion/moving_filter.hpp"
#include "self/neighbour_filter.hpp"

namespace pelt::detail {
namespace {

SurfaceTriangle at_start(const MovingSurfaceTriangle& t) { return {t.corners.from, t.vertices}; }
SurfaceTriangle at_end(const MovingSurfaceTriangle& t) { return {t.corners.to, t.vertices}; }

}  // namespace

void decide_neighbours(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b,
                       const Contact& contact, const MovingOptions& options,
                       Stack<MovingContact>& contacts, MovingStats& work) {
  ++work.double_pairs;
  if (certainly_apart(a, b)) return;
  if (surface_triangles_intersect(at_start(a), at_start(b))) {
    if (!options.leave_out_start) contacts.push({contact, 0, options.times, {}, {}});
    return;
  }
  if (!options.times && surface_triangles_intersect(at_end(a), at_end(b)))
    return contacts.push({contact, 0, false, {}, {}});
  ++work.exact_pairs;
  const std::optional<FirstMeeting> first = first_meeting_of_neighbours(a, b);
  if (!first) return;
  contacts.push(options.times ? moving_contact(contact, *first)
                              : MovingContact{contact, 0, false, {}, {}});
}

}  // namespace pelt::detail
