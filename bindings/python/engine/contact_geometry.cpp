#include <pelt/surface.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/pair_lists.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <algorithm>
#include <span>

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

/// Returns the geometry of all frames as arrays with the names of pelt.ContactGeometry, except the
/// columns of the contacts. Indices of traces count over all frames.
py::dict geometry_columns(std::span<const ContactGeometry> frames) {
  py::dict columns;
  add_traces(frames, columns);
  add_curves(frames, columns);
  add_patches(frames, columns);
  return columns;
}

/// Contacts of all frames, as a call of `collide` has returned them.
class GivenContacts {
 public:
  /// Throws an error unless the contacts ascend and exist.
  GivenContacts(const Column& frame, const Column& a, const Column& b, std::size_t frames,
                std::size_t triangles_a, std::size_t triangles_b)
      : begin_(frames + 1) {
    check_shape(a, "contacts, triangle_a", {frame.size()}, "[N]");
    check_shape(b, "contacts, triangle_b", {frame.size()}, "[N]");
    std::int64_t last_frame = 0;
    for (py::ssize_t i = 0; i < frame.size(); ++i) {
      const Contact contact = {static_cast<std::uint32_t>(a.at(i)),
                               static_cast<std::uint32_t>(b.at(i))};
      const bool is_new_frame = i == 0 || frame.at(i) != last_frame;
      const bool ascends =
          i == 0 || frame.at(i) > last_frame || (!is_new_frame && contacts_.back() < contact);
      if (frame.at(i) < 0 || static_cast<std::size_t>(frame.at(i)) >= frames || !ascends ||
          contact.triangle_a >= triangles_a || contact.triangle_b >= triangles_b)
        throw ArgumentError("contacts: row " + std::to_string(i) +
                            " is not in ascending order, or not of these models and frames");
      contacts_.push_back(contact);
      last_frame = frame.at(i);
      begin_[static_cast<std::size_t>(last_frame) + 1] = contacts_.size();
    }
    for (std::size_t f = 1; f <= frames; ++f) begin_[f] = std::max(begin_[f], begin_[f - 1]);
  }

  std::span<const Contact> of(std::size_t frame) const {
    return std::span(contacts_).subspan(begin_[frame], begin_[frame + 1] - begin_[frame]);
  }

  void check_sides() const {
    for (const Contact& contact : contacts_)
      if (contact.triangle_a >= contact.triangle_b)
        throw ArgumentError("contacts: expected triangle_a < triangle_b, as self_collide returns");
  }

 private:
  std::vector<Contact> contacts_;
  std::vector<std::size_t> begin_;  // [F + 1]
};

py::dict geometry_of_pair(const ClipPoses& a, const ClipPoses& b, const Column& frame,
                          const Column& triangle_a, const Column& triangle_b, const Run& run) {
  const std::size_t frames = common_frame_count(a, b);
  const GivenContacts contacts(frame, triangle_a, triangle_b, frames, a.model().triangle_count(),
                               b.model().triangle_count());
  std::vector<ContactGeometry> geometry(frames);
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    while (const auto f = queue.next())
      if (!contacts.of(*f).empty())
        describe_contacts(pose_a.at(*f), pose_b.at(*f), contacts.of(*f), scratch, geometry[*f]);
  });
  return geometry_columns(geometry);
}

py::dict geometry_of_one(const ClipPoses& poses, const Column& frame, const Column& triangle_a,
                         const Column& triangle_b, const Run& run) {
  const std::size_t frames = poses.frame_count(), triangles = poses.model().triangle_count();
  const GivenContacts contacts(frame, triangle_a, triangle_b, frames, triangles, triangles);
  contacts.check_sides();
  std::vector<ContactGeometry> geometry(frames);
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    while (const auto f = queue.next())
      if (!contacts.of(*f).empty())
        describe_contacts(pose.at(*f), contacts.of(*f), scratch, geometry[*f]);
  });
  return geometry_columns(geometry);
}

}  // namespace

void add_contact_geometry(py::module_& module) {
  module.def("contact_geometry", &geometry_of_pair, py::arg("a"), py::arg("b"), py::arg("frame"),
             py::arg("triangle_a"), py::arg("triangle_b"), py::arg("run"));
  module.def("self_contact_geometry", &geometry_of_one, py::arg("poses"), py::arg("frame"),
             py::arg("triangle_a"), py::arg("triangle_b"), py::arg("run"));
}

}  // namespace pelt::python
