#include <pelt/collide.hpp>
#include <pelt/distance.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/pair_lists.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <cstdint>

namespace pelt::python {
namespace {

/// FNV-1a, 64 bits. A copy, because the extension includes public headers only.
class Fnv1a64 {
 public:
  void add(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8)
      state_ = (state_ ^ static_cast<std::uint8_t>(word >> shift)) * 0x100000001b3u;
  }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Returns the hash that `pelt check` prints for these contacts: FNV-1a 64 over the little-endian
/// words frame, body_a, body_b, triangle_a and triangle_b of each contact.
std::uint64_t contact_hash(const Column& frames, const Column& triangles_a,
                           const Column& triangles_b, const Column& bodies_a,
                           const Column& bodies_b) {
  check_shape(triangles_a, "triangle_a", {frames.size()}, "[N]");
  check_shape(triangles_b, "triangle_b", {frames.size()}, "[N]");
  check_shape(bodies_a, "bodies_a", {frames.size()}, "[N]");
  check_shape(bodies_b, "bodies_b", {frames.size()}, "[N]");
  Fnv1a64 hash;
  for (py::ssize_t i = 0; i < frames.size(); ++i) {
    hash.add(static_cast<std::uint32_t>(frames.at(i)));
    hash.add(static_cast<std::uint32_t>(bodies_a.at(i)));
    hash.add(static_cast<std::uint32_t>(bodies_b.at(i)));
    hash.add(static_cast<std::uint32_t>(triangles_a.at(i)));
    hash.add(static_cast<std::uint32_t>(triangles_b.at(i)));
  }
  return hash.value();
}

/// Calls `query(pose_a, pose_b, scratch, list)` for each frame, and returns what it appends.
template <class Pair, class Query>
PairColumns pairs_of_frames(const ClipPoses& a, const ClipPoses& b, const Run& run,
                            const Query& query) {
  PairLists<Pair> found(common_frame_count(a, b));
  run_frames(found.lists.frame_count(), run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    std::vector<Pair>& list = found.lists.add_thread();
    while (const auto frame = queue.next()) {
      const std::size_t begin = list.size();
      const QueryStats stats = query(pose_a.at(*frame), pose_b.at(*frame), scratch, list);
      found.lists.set(*frame, list, begin);
      found.cut_short[*frame] = stats.cut_short;
    }
  });
  return found.columns();
}

PairColumns all_contacts(const ClipPoses& a, const ClipPoses& b, std::uint32_t max_contacts,
                         const Run& run) {
  return pairs_of_frames<Contact>(
      a, b, run, [&](Pose& pose_a, Pose& pose_b, Scratch& scratch, std::vector<Contact>& list) {
        return collide(pose_a, pose_b, scratch, list, {max_contacts});
      });
}

PairColumns all_near_pairs(const ClipPoses& a, const ClipPoses& b, double tolerance,
                           std::uint32_t max_pairs, const Run& run) {
  if (!(tolerance >= 0)) throw ArgumentError("tolerance: expected 0 or more");
  return pairs_of_frames<Contact>(
      a, b, run, [&](Pose& pose_a, Pose& pose_b, Scratch& scratch, std::vector<Contact>& list) {
        return clearance(pose_a, pose_b, tolerance, scratch, list, {max_pairs});
      });
}

/// Whether any triangles intersect, in each frame [F].
py::array_t<bool> all_intersect(const ClipPoses& a, const ClipPoses& b, const Run& run) {
  py::array_t<bool> result = new_array<bool>({common_frame_count(a, b)});
  bool* const out = result.mutable_data();
  run_frames(static_cast<std::size_t>(result.size()), run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    while (const auto frame = queue.next())
      out[*frame] = intersects(pose_a.at(*frame), pose_b.at(*frame), scratch).answer;
  });
  return result;
}

}  // namespace

void add_collide(py::module_& module) {
  module.def("collide", &all_contacts, py::arg("a"), py::arg("b"), py::arg("max_contacts"),
             py::arg("run"));
  module.def("clearance", &all_near_pairs, py::arg("a"), py::arg("b"), py::arg("tolerance"),
             py::arg("max_pairs"), py::arg("run"));
  module.def("intersects", &all_intersect, py::arg("a"), py::arg("b"), py::arg("run"));
  module.def("contact_hash", &contact_hash, py::arg("frame"), py::arg("triangle_a"),
             py::arg("triangle_b"), py::arg("bodies_a"), py::arg("bodies_b"));
}

}  // namespace pelt::python
