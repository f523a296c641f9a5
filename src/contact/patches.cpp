#include "contact/patches.hpp"

#include "base/disjoint_sets.hpp"
#include "base/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace pelt::detail {
namespace {

using Link = ContactLinks::Link;

/// Links each triangle of one side with the corners of its partner triangles.
void link_corners(const Surface& a, const Surface& b, const ContactGeometry& geometry,
                  ContactLinks& work) {
  work.links.clear();
  for (std::uint32_t i = 0; i < geometry.traces.size(); ++i) {
    const auto [in_a, in_b] = geometry.traces[i].contact;
    for (const std::uint32_t corner : b.corners[in_b]) work.links.push_back({{0, in_a, corner}, i});
    for (const std::uint32_t corner : a.corners[in_a]) work.links.push_back({{1, in_b, corner}, i});
  }
  std::sort(work.links.begin(), work.links.end(),
            [](const Link& x, const Link& y) { return x.key < y.key; });
}

/// Labels each trace with the lowest trace of its connected set.
void label_patches(std::uint32_t count, ContactLinks& work) {
  DisjointSets sets(count, work.labels);
  for (std::size_t i = 1; i < work.links.size(); ++i)
    if (work.links[i].key == work.links[i - 1].key)
      sets.join(work.links[i].owner, work.links[i - 1].owner);
  for (std::uint32_t i = 0; i < count; ++i) work.labels[i] = sets.find(i);
}

double length_of(const ContactTrace& trace) {
  return std::sqrt(squared_length(Vec3d(trace.to) - Vec3d(trace.from)));
}

/// Returns the most frequent value of the members; of equally frequent values, the lowest. `sorted`
/// is working memory.
std::uint16_t most_frequent(std::span<const std::uint32_t> members,
                            const std::vector<ContactTrace>& traces,
                            std::uint16_t ContactTrace::*joint,
                            std::vector<std::uint32_t>& sorted) {
  sorted.clear();
  for (const std::uint32_t member : members) sorted.push_back(traces[member].*joint);
  std::sort(sorted.begin(), sorted.end());
  std::size_t most = 0;
  std::uint32_t best = sorted[0];
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    if (end - begin > most) best = sorted[begin];
    most = std::max(most, end - begin);
  }
  return static_cast<std::uint16_t>(best);
}

/// If no trace has a length, all traces have the same weight.
ContactPatch describe(std::uint32_t first, std::span<const std::uint32_t> members,
                      const ContactGeometry& geometry, std::vector<std::uint32_t>& sorting) {
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
    normal = normal + share * Vec3d(trace.normal);
    patch.depth = std::max(patch.depth, trace.depth);
  }
  const double size = std::sqrt(squared_length(normal));
  patch.length = static_cast<float>(length);
  patch.point = to_float(point);
  if (size > 0) patch.normal = to_float((1 / size) * normal);
  patch.joint_a = most_frequent(members, geometry.traces, &ContactTrace::joint_a, sorting);
  patch.joint_b = most_frequent(members, geometry.traces, &ContactTrace::joint_b, sorting);
  return patch;
}

}  // namespace

void gather_patches(const Surface& a, const Surface& b, ContactLinks& work,
                    ContactGeometry& geometry) {
  link_corners(a, b, geometry, work);
  label_patches(static_cast<std::uint32_t>(geometry.traces.size()), work);
  std::vector<std::uint32_t>& members = geometry.members;
  members.resize(geometry.traces.size());
  for (std::uint32_t i = 0; i < members.size(); ++i) members[i] = i;
  const std::vector<std::uint32_t>& labels = work.labels;
  std::sort(members.begin(), members.end(), [&](std::uint32_t x, std::uint32_t y) {
    return labels[x] < labels[y] || (labels[x] == labels[y] && x < y);
  });
  geometry.patches.clear();
  for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
    while (end < members.size() && labels[members[end]] == labels[members[begin]]) ++end;
    geometry.patches.push_back(describe(static_cast<std::uint32_t>(begin),
                                        std::span(members).subspan(begin, end - begin), geometry,
                                        work.partners));
  }
  std::sort(geometry.patches.begin(), geometry.patches.end(),
            [](const ContactPatch& x, const ContactPatch& y) {
              return x.count > y.count || (x.count == y.count && x.first < y.first);
            });
}

}  // namespace pelt::detail
