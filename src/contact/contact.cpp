#include <pelt/contact.hpp>

#include "base/assert.hpp"
#include "base/require.hpp"
#include "contact/curves.hpp"
#include "contact/patches.hpp"
#include "contact/traces.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::ContactLinks;
using detail::Crossing;
using detail::TriangleReader;

/// Instance `a` or `b` of a query.
struct Side {
  TriangleReader triangles;
  const detail::Surface& surface;
};

/// Computes the traces, and the ends of segments as links of their curves.
QueryStats trace_contacts(Side a, Side b, std::span<const Contact> contacts, ContactLinks& links,
                          ContactGeometry& geometry) {
  QueryStats work;
  geometry.traces.clear();
  links.links.clear();
  detail::ContactCorners corners;
  for (const Contact& contact : contacts) {
    // Contacts are sorted: neighbours often share the triangle of `a`.
    if (geometry.traces.empty() || geometry.traces.back().contact.triangle_a != contact.triangle_a)
      corners.a = a.triangles.corners(contact.triangle_a, work);
    corners.b = b.triangles.corners(contact.triangle_b, work);
    ++work.triangle_pairs;
    Crossing crossing;
    const auto end = static_cast<std::uint32_t>(2 * geometry.traces.size());
    geometry.traces.push_back(trace_of(contact, corners, a.surface, b.surface, crossing));
    if (crossing.kind != detail::CrossingKind::segment) continue;
    for (const std::uint32_t i : {0u, 1u})
      links.links.push_back({key_of(crossing.ends[i], contact, a.surface, b.surface), end + i});
  }
  return work;
}

}  // namespace

QueryStats describe_contacts(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                             std::span<const Contact> contacts, Scratch& scratch,
                             ContactGeometry& geometry) {
  detail::require(detail::is_surface_of(surface_a, a) && detail::is_surface_of(surface_b, b),
                  "describe_contacts: a surface belongs to another model than its pose");
  PELT_ASSERT(std::is_sorted(contacts.begin(), contacts.end()));
  ContactLinks& links = scratch.detail().contact_links;
  const QueryStats work = trace_contacts(
      {TriangleReader(a.detail().posed_tree()), surface_a.detail()},
      {TriangleReader(b.detail().posed_tree()), surface_b.detail()}, contacts, links, geometry);
  detail::chain_curves(links, geometry);
  detail::gather_patches(surface_a.detail(), surface_b.detail(), links, geometry);
  return work;
}

}  // namespace pelt
