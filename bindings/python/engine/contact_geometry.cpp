#include <pelt/surface.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/geometry_columns.hpp"
#include "bindings/python/engine/pair_lists.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <algorithm>

namespace pelt::python {
namespace {

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
