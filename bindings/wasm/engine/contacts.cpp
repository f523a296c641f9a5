/// The geometry of contacts.

#include <pelt/surface.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"

#include <algorithm>

namespace pelt::wasm {
namespace {

/// Converts to the models' triangle numbers. Triangles outside of a model get an invalid number.
std::vector<Contact> in_models(std::span<const Contact> contacts, const Body& a, const Body& b) {
  std::vector<Contact> result;
  for (const Contact& contact : contacts)
    result.push_back(
        {contact.triangle_a - a.first_triangle, contact.triangle_b - b.first_triangle});
  return result;
}

/// Validates contacts from JavaScript. Returns null if they are valid.
const char* problem_of(std::span<const Contact> contacts, const SkinnedModel& a,
                       const SkinnedModel& b, bool is_self) {
  const auto in_range = [&](const Contact& contact) {
    return contact.triangle_a < a.triangle_count() && contact.triangle_b < b.triangle_count();
  };
  if (!std::all_of(contacts.begin(), contacts.end(), in_range))
    return "pairs: a triangle number is out of range";
  const auto not_less = [](const Contact& x, const Contact& y) { return !(x < y); };
  if (std::adjacent_find(contacts.begin(), contacts.end(), not_less) != contacts.end())
    return "pairs: expected the pairs of collide, in ascending order";
  const auto is_ordered = [](const Contact& c) { return c.triangle_a < c.triangle_b; };
  if (is_self && !std::all_of(contacts.begin(), contacts.end(), is_ordered))
    return "pairs: expected the pairs of selfCollide, with the lower triangle first";
  return nullptr;
}

struct Columns {
  std::vector<float> segments, normals, depths;
  std::vector<std::uint8_t> kinds;
  std::vector<std::uint16_t> joints;
  std::vector<float> points;          // of all curves
  std::vector<std::uint32_t> curves;  // [C][3] begin, end, whether it is closed
  std::vector<double> patches;        // [R][12] in the order of write_patch
};

void push(std::vector<float>& floats, const Vec3& v) {
  floats.insert(floats.end(), {v.x, v.y, v.z});
}

void write_trace(const ContactTrace& trace, Columns& columns) {
  push(columns.segments, trace.from);
  push(columns.segments, trace.to);
  push(columns.normals, trace.normal);
  columns.depths.push_back(trace.depth);
  columns.kinds.push_back(static_cast<std::uint8_t>(trace.kind));
  columns.joints.insert(columns.joints.end(), {trace.joint_a, trace.joint_b});
}

/// Writes the points of a curve in the direction of traversal.
void write_curve(const ContactGeometry& geometry, const ContactCurve& curve, Columns& columns) {
  const std::size_t begin = columns.points.size() / 3;
  for (std::uint32_t s = curve.first; s < curve.first + curve.count; ++s) {
    const CurveStep& step = geometry.steps[s];
    const ContactTrace& trace = geometry.traces[step.trace];
    if (s == curve.first) push(columns.points, step.is_reversed ? trace.to : trace.from);
    push(columns.points, step.is_reversed ? trace.from : trace.to);
  }
  const std::size_t end = columns.points.size() / 3;
  columns.curves.insert(columns.curves.end(),
                        {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                         curve.is_closed ? 1u : 0u});
}

void write_patch(const ContactPatch& patch, Columns& columns) {
  const auto& [x, y, z] = patch.point;
  const auto& [nx, ny, nz] = patch.normal;
  const auto number = [](std::uint32_t whole) { return static_cast<double>(whole); };
  const double begin = number(patch.first), end = number(patch.first + patch.count);
  columns.patches.insert(columns.patches.end(),
                         {begin, end, patch.length, patch.depth, x, y, z, nx, ny, nz,
                          number(patch.joint_a), number(patch.joint_b)});
}

void write_columns(const ContactGeometry& geometry, Columns& columns) {
  columns = {};
  for (const ContactTrace& trace : geometry.traces) write_trace(trace, columns);
  for (const ContactCurve& curve : geometry.curves) write_curve(geometry, curve, columns);
  for (const ContactPatch& patch : geometry.patches) write_patch(patch, columns);
}

}  // namespace

/// Answers with the columns in the order of queries.mjs. The same pose twice: contacts of the pose
/// with itself.
Result<QueryStats> describe_contacts(PoseHandle& a, PoseHandle& b,
                                     std::span<const Contact> contacts) {
  static ContactGeometry geometry;
  static Columns columns;
  const bool is_self = &a == &b;
  const std::vector<Contact> given = in_models(contacts, a.body, b.body);
  if (const char* problem = problem_of(given, a.pose.model(), b.pose.model(), is_self))
    return Error{ErrorCode::invalid_argument, problem};
  const QueryStats stats = is_self ? describe_contacts(a.pose, given, scratch(), geometry)
                                   : describe_contacts(a.pose, b.pose, given, scratch(), geometry);
  write_columns(geometry, columns);
  answer_arrays(columns.segments, columns.normals, columns.depths, columns.kinds, columns.joints,
                columns.points, columns.curves, columns.patches, geometry.members);
  return stats;
}
PELT_EXPORT(describe_contacts)

}  // namespace pelt::wasm
