#include <pelt/surface.hpp>

#include "base/assert.hpp"
#include "base/require.hpp"
#include "contact/curves.hpp"
#include "contact/traces.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::ContactLinks;
using detail::ContactSurfaces;
using detail::EndKey;
using detail::TriangleReader;

/// Whether a curve goes on from an end. If both triangles share the corner in which a trace of a
/// pose with itself begins, the trace has no other side there.
bool may_continue(const EndKey& end, const ContactSurfaces& surfaces) {
  return !surfaces.is_self || end.first != end.second;
}

void link_ends(const std::array<EndKey, 2>& ends, std::uint32_t trace,
               const ContactSurfaces& surfaces, std::vector<ContactLinks::Link>& links) {
  for (const std::uint32_t i : {0u, 1u}) {
    const auto& [first, second, is_swapped] = ends[i];
    if (may_continue(ends[i], surfaces))
      links.push_back(
          {{first[0], first[1], first[2], second[0], second[1], second[2]}, 2 * trace + i});
  }
}

/// Computes the traces, and the ends of segments as links of their curves.
QueryStats trace_contacts(TriangleReader a, TriangleReader b, const ContactSurfaces& surfaces,
                          std::span<const Contact> contacts, ContactLinks& links,
                          ContactGeometry& geometry) {
  QueryStats work;
  geometry.traces.clear();
  links.links.clear();
  detail::ContactCorners corners;
  for (const Contact& contact : contacts) {
    // Contacts are sorted: neighbours often share the triangle of `a`.
    if (geometry.traces.empty() || geometry.traces.back().contact.triangle_a != contact.triangle_a)
      corners.a = a.corners(contact.triangle_a, work);
    corners.b = b.corners(contact.triangle_b, work);
    ++work.triangle_pairs;
    std::array<EndKey, 2> ends;
    const auto trace = static_cast<std::uint32_t>(geometry.traces.size());
    geometry.traces.push_back(trace_of(contact, corners, surfaces, ends));
    if (geometry.traces.back().kind == ContactKind::segment)
      link_ends(ends, trace, surfaces, links.links);
  }
  return work;
}

QueryStats describe(const detail::PosedTree& a, const detail::PosedTree& b,
                    const ContactSurfaces& surfaces, std::span<const Contact> contacts,
                    Scratch& scratch, ContactGeometry& geometry) {
  PELT_ASSERT(std::is_sorted(contacts.begin(), contacts.end()));
  ContactLinks& links = scratch.detail().contact_links;
  const QueryStats work =
      trace_contacts(TriangleReader(a), TriangleReader(b), surfaces, contacts, links, geometry);
  detail::chain_curves(links, geometry);
  detail::gather_patches(surfaces, links, geometry);
  return work;
}

}  // namespace

QueryStats describe_contacts(Pose& a, Pose& b, std::span<const Contact> contacts, Scratch& scratch,
                             ContactGeometry& geometry) {
  detail::require(&a != &b, "describe_contacts: `a` and `b` are the same pose; give one pose");
  return describe(a.detail().posed_tree(), b.detail().posed_tree(),
                  {detail::surface_of(a), detail::surface_of(b)}, contacts, scratch, geometry);
}

QueryStats describe_contacts(Pose& pose, std::span<const Contact> contacts, Scratch& scratch,
                             ContactGeometry& geometry) {
  const detail::Surface& surface = detail::surface_of(pose);
  const detail::PosedTree posed = pose.detail().posed_tree();
  return describe(posed, posed, {surface, surface, true}, contacts, scratch, geometry);
}

}  // namespace pelt
