/// Descriptions of contacts: traces, chained to curves and gathered to patches.

#include <pelt/surface.hpp>

#include "base/assert.hpp"
#include "base/disjoint_sets.hpp"
#include "base/vec3.hpp"
#include "contact/traces.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"

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

/// Chains the segments of `geometry` into curves. The links contain the ends of segments: `owner`
/// is twice the index of the trace, plus one for the end `to`. A curve ends where there is no link.
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

using Link = ContactLinks::Link;

/// Links each triangle of one side with the corners of its partner triangle.
void link_corners(const Contact& contact, std::uint32_t owner, const ContactSurfaces& surfaces,
                  std::vector<Link>& links) {
  const auto [in_a, in_b] = contact;
  for (const std::uint32_t corner : surfaces.b.corners[in_b])
    links.push_back({{0, in_a, corner}, owner});
  for (const std::uint32_t corner : surfaces.a.corners[in_a])
    links.push_back({{1, in_b, corner}, owner});
}

/// In contacts of a pose with itself, either triangle may have the lower number, so a contact
/// counts twice, once with each triangle as that of `a`: as owner 2 i and 2 i + 1 for trace i.
void link_all_corners(const ContactSurfaces& surfaces, const ContactGeometry& geometry,
                      std::vector<Link>& links) {
  links.clear();
  for (std::uint32_t i = 0; i < geometry.traces.size(); ++i) {
    const Contact& contact = geometry.traces[i].contact;
    link_corners(contact, 2 * i, surfaces, links);
    if (surfaces.is_self)
      link_corners({contact.triangle_b, contact.triangle_a}, 2 * i + 1, surfaces, links);
  }
  std::sort(links.begin(), links.end(), [](const Link& x, const Link& y) { return x.key < y.key; });
}

/// Labels each trace with twice the lowest trace of its connected set, plus one if the sides of the
/// two traces are swapped. A connected set that contains a trace both ways has no sides: its traces
/// count as not swapped.
void label_patches(std::uint32_t count, ContactLinks& work) {
  std::vector<std::uint32_t>& labels = work.labels;
  DisjointSets sets(2 * count, labels);
  for (std::size_t i = 1; i < work.links.size(); ++i)
    if (work.links[i].key == work.links[i - 1].key)
      sets.join(work.links[i].owner, work.links[i - 1].owner);
  for (std::uint32_t i = 0; i < 2 * count; ++i) labels[i] = sets.find(i);
  for (std::size_t i = 0; i < count; ++i)
    labels[i] = labels[2 * i] <= labels[2 * i + 1] ? labels[2 * i] : labels[2 * i + 1] + 1;
}

/// A trace with the sides of its patch.
class PatchTrace {
 public:
  PatchTrace(std::uint32_t trace, const ContactGeometry& geometry, const ContactLinks& work)
      : trace_(geometry.traces[trace]), is_swapped_(work.labels[trace] % 2 == 1) {}

  Vec3d normal() const { return (is_swapped_ ? -1.0 : 1.0) * Vec3d(trace_.normal); }
  std::uint16_t joint_a() const { return is_swapped_ ? trace_.joint_b : trace_.joint_a; }
  std::uint16_t joint_b() const { return is_swapped_ ? trace_.joint_a : trace_.joint_b; }

 private:
  const ContactTrace& trace_;
  bool is_swapped_;
};

/// Sorts the values, and returns the most frequent one; of equally frequent values, the lowest.
std::uint16_t most_frequent(std::vector<std::uint32_t>& values) {
  std::sort(values.begin(), values.end());
  std::size_t most = 0;
  std::uint32_t best = values[0];
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    while (end < values.size() && values[end] == values[begin]) ++end;
    if (end - begin > most) best = values[begin];
    most = std::max(most, end - begin);
  }
  return static_cast<std::uint16_t>(best);
}

void add_joints(std::span<const std::uint32_t> members, const ContactGeometry& geometry,
                ContactLinks& work, ContactPatch& patch) {
  const auto most_frequent_joint = [&](std::uint16_t (PatchTrace::*joint)() const) {
    work.partners.clear();
    for (const std::uint32_t member : members)
      work.partners.push_back((PatchTrace(member, geometry, work).*joint)());
    return most_frequent(work.partners);
  };
  patch.joint_a = most_frequent_joint(&PatchTrace::joint_a);
  patch.joint_b = most_frequent_joint(&PatchTrace::joint_b);
}

/// If no trace has a length, all traces have the same weight.
ContactPatch describe(std::uint32_t first, std::span<const std::uint32_t> members,
                      const ContactGeometry& geometry, ContactLinks& work) {
  ContactPatch patch;
  patch.first = first;
  patch.count = static_cast<std::uint32_t>(members.size());
  double length = 0;
  for (const std::uint32_t member : members) length += length_of(geometry.traces[member]);
  Vec3d point, normal;
  for (const std::uint32_t member : members) {
    const ContactTrace& trace = geometry.traces[member];
    const double share = length > 0 ? length_of(trace) / length : 1.0 / patch.count;
    point = point + 0.5 * share * (Vec3d(trace.from) + Vec3d(trace.to));
    normal = normal + share * PatchTrace(member, geometry, work).normal();
    patch.depth = std::max(patch.depth, trace.depth);
  }
  const double size = std::sqrt(squared_length(normal));
  patch.length = static_cast<float>(length);
  patch.point = to_float(point);
  if (size > 0) patch.normal = to_float((1 / size) * normal);
  add_joints(members, geometry, work, patch);
  return patch;
}

/// Sorts the traces by patch.
void sort_members(const std::vector<std::uint32_t>& labels, std::vector<std::uint32_t>& members) {
  for (std::uint32_t i = 0; i < members.size(); ++i) members[i] = i;
  std::sort(members.begin(), members.end(), [&](std::uint32_t x, std::uint32_t y) {
    return labels[x] / 2 < labels[y] / 2 || (labels[x] / 2 == labels[y] / 2 && x < y);
  });
}

/// Gathers the traces of `geometry` into patches.
void gather_patches(const ContactSurfaces& surfaces, ContactLinks& work,
                    ContactGeometry& geometry) {
  link_all_corners(surfaces, geometry, work.links);
  label_patches(static_cast<std::uint32_t>(geometry.traces.size()), work);
  std::vector<std::uint32_t>& members = geometry.members;
  members.resize(geometry.traces.size());
  sort_members(work.labels, members);
  geometry.patches.clear();
  for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
    const std::uint32_t patch = work.labels[members[begin]] / 2;
    while (end < members.size() && work.labels[members[end]] / 2 == patch) ++end;
    geometry.patches.push_back(describe(static_cast<std::uint32_t>(begin),
                                        std::span(members).subspan(begin, end - begin), geometry,
                                        work));
  }
  std::sort(geometry.patches.begin(), geometry.patches.end(),
            [](const ContactPatch& x, const ContactPatch& y) {
              return x.count > y.count || (x.count == y.count && x.first < y.first);
            });
}

}  // namespace
}  // namespace pelt::detail

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
