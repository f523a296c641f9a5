#include <pelt/contact.hpp>

#include "base/assert.hpp"
#include "contact/curves.hpp"
#include "contact/regions.hpp"
#include "contact/traces.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::Crossing;
using detail::PosedSurface;

/// Computes the traces, and the ends of segments as links of their curves.
QueryStats trace_contacts(const PosedSurface& a, const PosedSurface& b,
                          std::span<const Contact> contacts, ContactGeometry& geometry) {
  QueryStats work;
  geometry.traces.clear();
  geometry.links.clear();
  for (const Contact& contact : contacts) {
    Crossing crossing;
    const auto end = static_cast<std::uint32_t>(2 * geometry.traces.size());
    geometry.traces.push_back(trace_of(contact, a, b, crossing, work));
    if (crossing.kind != detail::CrossingKind::segment) continue;
    for (const std::uint32_t i : {0u, 1u})
      geometry.links.push_back({key_of(crossing.ends[i], contact, a.surface, b.surface), end + i});
  }
  return work;
}

}  // namespace

QueryStats describe_contacts(Pose& a, const Surface& surface_a, Pose& b, const Surface& surface_b,
                             std::span<const Contact> contacts, ContactGeometry& geometry) {
  PELT_ASSERT(&a.model().detail() == &surface_a.model().detail());
  PELT_ASSERT(&b.model().detail() == &surface_b.model().detail());
  PELT_ASSERT(std::is_sorted(contacts.begin(), contacts.end()));
  const QueryStats work = trace_contacts({a.detail(), surface_a.detail()},
                                         {b.detail(), surface_b.detail()}, contacts, geometry);
  detail::chain_curves(geometry);
  detail::gather_regions(surface_a.detail(), surface_b.detail(), geometry);
  return work;
}

}  // namespace pelt
