#include "contact/curves.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

using Link = ContactLinks::Link;

/// Finds for each end the end with the same key; kNone if there is none or more than one.
void find_partners(std::size_t trace_count, ContactLinks& work) {
  std::vector<Link>& links = work.links;
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return a.key < b.key || (a.key == b.key && a.owner < b.owner);
  });
  work.partners.assign(2 * trace_count, kNone);
  for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
    while (end < links.size() && links[end].key == links[begin].key) ++end;
    if (end - begin != 2) continue;
    work.partners[links[begin].owner] = links[begin + 1].owner;
    work.partners[links[begin + 1].owner] = links[begin].owner;
  }
}

/// Follows a curve from the entered end of a trace until it ends or closes.
void walk(std::uint32_t entered, ContactLinks& work, ContactGeometry& geometry) {
  std::vector<std::uint32_t>& is_walked = work.labels;
  ContactCurve curve = {static_cast<std::uint32_t>(geometry.steps.size()), 0, false};
  const std::uint32_t start = entered;
  do {
    is_walked[entered / 2] = 1;
    geometry.steps.push_back({entered / 2, entered % 2 == 1});
    ++curve.count;
    entered = work.partners[entered ^ 1];  // continue at the partner of the other end
  } while (entered != kNone && entered != start);
  curve.is_closed = entered == start;
  geometry.curves.push_back(curve);
}

}  // namespace

void chain_curves(ContactLinks& work, ContactGeometry& geometry) {
  find_partners(geometry.traces.size(), work);
  geometry.steps.clear();
  geometry.curves.clear();
  work.labels.assign(geometry.traces.size(), 0);
  const auto is_open = [&](std::uint32_t trace) {
    return geometry.traces[trace].kind == ContactKind::segment && work.labels[trace] == 0;
  };
  // Open curves first; otherwise their middles would be mistaken for starts of closed curves.
  for (std::uint32_t end = 0; end < work.partners.size(); ++end)
    if (is_open(end / 2) && work.partners[end] == kNone) walk(end, work, geometry);
  for (std::uint32_t trace = 0; trace < geometry.traces.size(); ++trace)
    if (is_open(trace)) walk(2 * trace, work, geometry);
}

}  // namespace pelt::detail
