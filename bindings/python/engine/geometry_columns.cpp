#include "bindings/python/engine/geometry_columns.hpp"

#include "bindings/python/engine/points.hpp"

namespace pelt::python {
namespace {

using Frames = std::span<const ContactGeometry>;

template <class Item>
std::size_t count_all(Frames frames, std::vector<Item> ContactGeometry::*list) {
  std::size_t sum = 0;
  for (const ContactGeometry& frame : frames) sum += (frame.*list).size();
  return sum;
}

/// Calls `visit(place, item)` for the items of all frames. `place` counts from 0.
template <class Item, class Visit>
void visit_all(Frames frames, std::vector<Item> ContactGeometry::*list, const Visit& visit) {
  std::size_t place = 0;
  for (const ContactGeometry& frame : frames)
    for (const Item& item : frame.*list) visit(place++, item);
}

/// Returns the column of a number of each item.
template <class T, class Item, class Get>
py::array_t<T> column(Frames frames, std::vector<Item> ContactGeometry::*list, const Get& get) {
  py::array_t<T> result = new_array<T>({count_all(frames, list)});
  T* const out = result.mutable_data();
  visit_all(frames, list,
            [&](std::size_t place, const Item& item) { out[place] = static_cast<T>(get(item)); });
  return result;
}

/// Returns the column of a vector of each item.
template <class Item>
py::array_t<float> vectors(Frames frames, std::vector<Item> ContactGeometry::*list,
                           Vec3 Item::*member) {
  py::array_t<float> result = new_array<float>({count_all(frames, list), 3});
  float* const out = result.mutable_data();
  visit_all(frames, list, [&](std::size_t place, const Item& item) {
    SurfacePointColumns::set_vector(out, place, item.*member);
  });
  return result;
}

/// Returns the frame of each item.
template <class Item>
py::array_t<std::int32_t> frames_of(Frames frames, std::vector<Item> ContactGeometry::*list) {
  py::array_t<std::int32_t> result = new_array<std::int32_t>({count_all(frames, list)});
  std::int32_t* out = result.mutable_data();
  for (std::size_t f = 0; f < frames.size(); ++f)
    out = std::fill_n(out, (frames[f].*list).size(), static_cast<std::int32_t>(f));
  return result;
}

/// Returns where the range of each item begins, and where the last one ends.
template <class Item>
py::array_t<std::int64_t> begins(Frames frames, std::vector<Item> ContactGeometry::*list) {
  py::array_t<std::int64_t> result = new_array<std::int64_t>({count_all(frames, list) + 1});
  std::int64_t* out = result.mutable_data();
  std::int64_t end = 0;
  visit_all(frames, list, [&](std::size_t, const Item& item) {
    *out++ = end;
    end += item.count;
  });
  *out = end;
  return result;
}

/// Returns indices of traces, counted over all frames.
template <class Item, class Get>
py::array_t<std::int64_t> traces(Frames frames, std::vector<Item> ContactGeometry::*list,
                                 const Get& get) {
  py::array_t<std::int64_t> result = new_array<std::int64_t>({count_all(frames, list)});
  std::int64_t* out = result.mutable_data();
  std::int64_t first = 0;
  for (const ContactGeometry& frame : frames) {
    for (const Item& item : frame.*list) *out++ = first + static_cast<std::int64_t>(get(item));
    first += static_cast<std::int64_t>(frame.traces.size());
  }
  return result;
}

void add_traces(Frames frames, py::dict& columns) {
  constexpr auto list = &ContactGeometry::traces;
  const auto number = [](const ContactTrace& t) { return static_cast<int>(t.kind); };
  columns["kind"] = column<std::uint8_t>(frames, list, number);
  columns["start"] = vectors(frames, list, &ContactTrace::from);
  columns["end"] = vectors(frames, list, &ContactTrace::to);
  columns["normal"] = vectors(frames, list, &ContactTrace::normal);
  columns["depth"] = column<float>(frames, list, [](const ContactTrace& t) { return t.depth; });
  columns["joint_a"] =
      column<std::int32_t>(frames, list, [](const ContactTrace& t) { return t.joint_a; });
  columns["joint_b"] =
      column<std::int32_t>(frames, list, [](const ContactTrace& t) { return t.joint_b; });
}

void add_curves(Frames frames, py::dict& columns) {
  constexpr auto list = &ContactGeometry::curves;
  columns["curve_frame"] = frames_of(frames, list);
  columns["curve_begin"] = begins(frames, list);
  columns["curve_closed"] =
      column<bool>(frames, list, [](const ContactCurve& c) { return c.is_closed; });
  constexpr auto steps = &ContactGeometry::steps;
  columns["curve_trace"] = traces(frames, steps, [](const CurveStep& s) { return s.trace; });
  columns["curve_reversed"] =
      column<bool>(frames, steps, [](const CurveStep& s) { return s.is_reversed; });
}

void add_patches(Frames frames, py::dict& columns) {
  constexpr auto list = &ContactGeometry::patches;
  columns["patch_frame"] = frames_of(frames, list);
  columns["patch_begin"] = begins(frames, list);
  columns["patch_trace"] =
      traces(frames, &ContactGeometry::members, [](std::uint32_t trace) { return trace; });
  columns["patch_length"] =
      column<float>(frames, list, [](const ContactPatch& p) { return p.length; });
  columns["patch_point"] = vectors(frames, list, &ContactPatch::point);
  columns["patch_normal"] = vectors(frames, list, &ContactPatch::normal);
  columns["patch_depth"] =
      column<float>(frames, list, [](const ContactPatch& p) { return p.depth; });
  columns["patch_joint_a"] =
      column<std::int32_t>(frames, list, [](const ContactPatch& p) { return p.joint_a; });
  columns["patch_joint_b"] =
      column<std::int32_t>(frames, list, [](const ContactPatch& p) { return p.joint_b; });
}

}  // namespace

py::dict geometry_columns(std::span<const ContactGeometry> frames) {
  py::dict columns;
  add_traces(frames, columns);
  add_curves(frames, columns);
  add_patches(frames, columns);
  return columns;
}

}  // namespace pelt::python
