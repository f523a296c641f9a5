/// The geometry of contacts, in arrays that JavaScript reads one by one.

#include <pelt/surface.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

#include <algorithm>
#include <initializer_list>

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

/// Returned arrays, valid until the next call.
struct Columns {
  std::vector<float> segments, normals, depths;
  std::vector<std::uint8_t> kinds;
  std::vector<std::uint16_t> joints;
  std::vector<float> points;          // of all curves
  std::vector<std::uint32_t> curves;  // [C][3] begin, end, whether it is closed
  std::vector<double> patches;        // [R][12] in the order of write_patch
};

ContactGeometry& geometry() {
  static ContactGeometry geometry;
  return geometry;
}

Columns& columns() {
  static Columns columns;
  return columns;
}

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
  const std::initializer_list<double> row = {static_cast<double>(patch.first),
                                             static_cast<double>(patch.first + patch.count),
                                             patch.length,
                                             patch.depth,
                                             x,
                                             y,
                                             z,
                                             nx,
                                             ny,
                                             nz,
                                             static_cast<double>(patch.joint_a),
                                             static_cast<double>(patch.joint_b)};
  columns.patches.insert(columns.patches.end(), row);
}

void write_columns(const ContactGeometry& geometry, Columns& columns) {
  columns = {};
  for (const ContactTrace& trace : geometry.traces) write_trace(trace, columns);
  for (const ContactCurve& curve : geometry.curves) write_curve(geometry, curve, columns);
  for (const ContactPatch& patch : geometry.patches) write_patch(patch, columns);
}

}  // namespace

/// Describes contacts. Read the arrays with pelt_contact_column.
/// The same pose twice: contacts of the pose with itself.
PELT_EXPORT std::uint32_t pelt_describe_contacts(PoseHandle* a, PoseHandle* b,
                                                 const Contact* contacts, std::uint32_t count) {
  const std::vector<Contact> given = in_models({contacts, count}, a->body, b->body);
  if (const char* problem = problem_of(given, a->pose.model(), b->pose.model(), a == b))
    return refuse({ErrorCode::invalid_argument, problem});
  answer_stats(a == b ? describe_contacts(a->pose, given, scratch(), geometry())
                      : describe_contacts(a->pose, b->pose, given, scratch(), geometry()));
  write_columns(geometry(), columns());
  return 1;
}

/// Same order as in queries.mjs.
enum class Column : std::uint32_t {
  segments,
  normals,
  depths,
  kinds,
  joints,
  points,
  curves,
  patches,
  members,
};

PELT_EXPORT void pelt_contact_column(Column column) {
  switch (column) {
    case Column::segments:
      return answer_data<float>(columns().segments);
    case Column::normals:
      return answer_data<float>(columns().normals);
    case Column::depths:
      return answer_data<float>(columns().depths);
    case Column::kinds:
      return answer_data<std::uint8_t>(columns().kinds);
    case Column::joints:
      return answer_data<std::uint16_t>(columns().joints);
    case Column::points:
      return answer_data<float>(columns().points);
    case Column::curves:
      return answer_data<std::uint32_t>(columns().curves);
    case Column::patches:
      return answer_data<double>(columns().patches);
    case Column::members:
      return answer_data<std::uint32_t>(geometry().members);
  }
}

}  // namespace pelt::wasm
