#include "contact/curves.hpp"

#include "base/vec3.hpp"
#include "contact/traces.hpp"

#include <algorithm>
#include <cmath>
#include <span>

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

/// The magnitude of the vector area of a closed curve. Positions are relative to the start of the
/// curve, because far from the origin, products would cancel each other.
double area_of(std::span<const CurveStep> steps, const std::vector<ContactTrace>& traces) {
  const Vec3d start(traces[steps[0].trace].from);
  Vec3d sum;
  for (const CurveStep& step : steps) {
    const Vec3d from = Vec3d(traces[step.trace].from) - start;
    const Vec3d to = Vec3d(traces[step.trace].to) - start;
    sum = sum + (step.is_reversed ? cross(to, from) : cross(from, to));
  }
  return std::sqrt(squared_length(sum)) / 2;
}

void measure(ContactCurve& curve, const ContactGeometry& geometry) {
  const auto steps = std::span(geometry.steps).subspan(curve.first, curve.count);
  double length = 0;
  for (const CurveStep& step : steps) length += length_of(geometry.traces[step.trace]);
  curve.length = static_cast<float>(length);
  if (curve.is_closed) curve.area = static_cast<float>(area_of(steps, geometry.traces));
}

/// Follows a curve from the entered end of a trace until it ends or closes.
void walk(std::uint32_t entered, ContactLinks& work, ContactGeometry& geometry) {
  std::vector<std::uint32_t>& is_walked = work.labels;
  ContactCurve curve;
  curve.first = static_cast<std::uint32_t>(geometry.steps.size());
  const std::uint32_t start = entered;
  do {
    is_walked[entered / 2] = 1;
    geometry.steps.push_back({entered / 2, entered % 2 == 1});
    ++curve.count;
    entered = work.partners[entered ^ 1];  // continue at the partner of the other end
  } while (entered != kNone && entered != start);
  curve.is_closed = entered == start;
  measure(curve, geometry);
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
