#include <pelt/self.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/index_arrays.hpp"
#include "bindings/python/engine/moving_columns.hpp"
#include "bindings/python/engine/pair_lists.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <mutex>
#include <utility>

namespace pelt::python {
namespace {

/// The arrays of SelfFilterOptions, as Python gives them. Absent arrays are empty.
struct FilterArrays {
  std::vector<std::uint8_t> takes_part;
  std::vector<Contact> at_rest, always;
  std::vector<std::uint16_t> joint_bodies, joint_parents, groups;
  std::vector<IndexPair> joint_pairs, joint_pairs_in_zones, group_pairs;
  std::vector<TriangleZone> zones;
};

std::vector<TriangleZone> read_zones(const std::optional<Integers>& array, std::size_t triangles) {
  std::vector<TriangleZone> zones;
  for (const auto& [triangle, zone] :
       read_pairs<Contact, std::uint32_t>(array, "zones", std::max(kNumbers, triangles))) {
    if (zone >= kNumbers) throw ArgumentError("zones: expected numbers of zones up to 65535");
    zones.push_back({triangle, static_cast<std::uint16_t>(zone)});
  }
  return zones;
}

std::vector<std::uint8_t> read_flags(const std::optional<Integers>& array) {
  std::vector<std::uint8_t> flags;
  if (!array) return flags;
  check_shape(*array, "takes_part", {-1}, "[T]");
  for (py::ssize_t t = 0; t < array->size(); ++t) flags.push_back(array->at(t) != 0);
  return flags;
}

using Optional = std::optional<Integers>;

SelfFilter make_filter(const SkinnedModel& model, std::uint32_t rings, const Optional& takes_part,
                       const Optional& at_rest, const Optional& always,
                       const Optional& joint_bodies, const Optional& joint_parents,
                       const Optional& joint_pairs, const Optional& joint_pairs_in_zones,
                       const Optional& zones, const Optional& groups, const Optional& group_pairs) {
  const std::size_t triangles = model.triangle_count();
  const FilterArrays arrays = {
      read_flags(takes_part),
      read_pairs<Contact, std::uint32_t>(at_rest, "at_rest", triangles),
      read_pairs<Contact, std::uint32_t>(always, "always", triangles),
      read_numbers(joint_bodies, "joint_bodies"),
      read_parents(joint_parents, "joint_parents"),
      read_numbers(groups, "groups"),
      read_pairs<IndexPair, std::uint16_t>(joint_pairs, "joint_pairs", kNumbers),
      read_pairs<IndexPair, std::uint16_t>(joint_pairs_in_zones, "joint_pairs_in_zones", kNumbers),
      read_pairs<IndexPair, std::uint16_t>(group_pairs, "group_pairs", kNumbers),
      read_zones(zones, triangles)};
  const py::gil_scoped_release unlocked;
  return value_of(build_self_filter(model, {rings, arrays.takes_part, arrays.at_rest, arrays.always,
                                            arrays.joint_bodies, arrays.joint_parents,
                                            arrays.joint_pairs, arrays.joint_pairs_in_zones,
                                            arrays.zones, arrays.groups, arrays.group_pairs}),
                  "SelfFilter");
}

using Counts = std::map<std::string, std::uint64_t>;

Counts counts_of(const LeftOut& left_out) {
  return {{"takes_part", left_out.takes_part}, {"rings", left_out.rings},
          {"at_rest", left_out.at_rest},       {"always", left_out.always},
          {"joints", left_out.joints},         {"groups", left_out.groups}};
}

/// Adds up what the threads have left out.
class LeftOutSum {
 public:
  void add(const LeftOut& left_out) {
    const std::lock_guard lock(mutex_);
    sum_ += left_out;
  }
  Counts counts() const { return counts_of(sum_); }

 private:
  std::mutex mutex_;
  LeftOut sum_;
};

std::pair<PairColumns, Counts> all_self_contacts(const ClipPoses& poses, const SelfFilter& filter,
                                                 std::uint32_t max_contacts, const Run& run) {
  check_model(poses, filter, "ignore");
  PairLists<Contact> found(poses.frame_count());
  LeftOutSum left_out;
  run_frames(poses.frame_count(), run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    LeftOut sum;
    std::vector<Contact>& list = found.lists.add_thread();
    while (const auto frame = queue.next()) {
      const std::size_t begin = list.size();
      const SelfStats stats = self_collide(pose.at(*frame), filter, scratch, list, {max_contacts});
      found.lists.set(*frame, list, begin);
      found.cut_short[*frame] = stats.cut_short;
      sum += stats.left_out;
    }
    left_out.add(sum);
  });
  return {found.columns(), left_out.counts()};
}

/// Returns which pairs [N] of triangles a filter does not leave out, and how many each filter does.
std::pair<py::array_t<bool>, Counts> kept_pairs(const SelfFilter& filter, const Integers& pairs) {
  const std::size_t triangles = filter.model().triangle_count();
  auto given = read_pairs<Contact, std::uint32_t>(pairs, "contacts", triangles);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i].triangle_a == given[i].triangle_b)
      throw ArgumentError("contacts: pair " + std::to_string(i) + " is a triangle with itself");
    if (given[i].triangle_a > given[i].triangle_b)
      std::swap(given[i].triangle_a, given[i].triangle_b);
  }
  std::vector<Contact> remaining = given;
  Scratch scratch;
  const LeftOut left_out = leave_out(filter, scratch, remaining);
  py::array_t<bool> kept = new_array<bool>({given.size()});
  bool* const out = kept.mutable_data();
  // The order of the remaining pairs has not changed, and equal pairs share their fate.
  auto next = remaining.begin();
  for (std::size_t i = 0; i < given.size(); ++i) {
    out[i] = next != remaining.end() && *next == given[i];
    if (out[i]) ++next;
  }
  return {kept, counts_of(left_out)};
}

std::pair<MovingColumns, Counts> all_self_moving(const ClipPoses& poses, const SelfFilter& filter,
                                                 bool leave_out_start, bool times,
                                                 std::uint32_t max_contacts, const Run& run) {
  check_model(poses, filter, "ignore");
  const std::size_t steps = step_count(poses.frame_count());
  FrameLists<MovingContact> found(steps);
  LeftOutSum left_out;
  run_frames(
      steps, run,
      [&](FrameQueue& queue) {
        FrameMotion motion(poses);
        Scratch scratch;
        LeftOut sum;
        std::vector<MovingContact>& list = found.add_thread();
        while (const auto step = queue.next()) {
          const std::size_t begin = list.size();
          sum += self_collide(motion.at(*step), filter, scratch, list,
                              {leave_out_start, times, max_contacts})
                     .left_out;
          found.set(*step, list, begin);
        }
        left_out.add(sum);
      },
      kStepsAtATime);
  return {moving_columns(found), left_out.counts()};
}

}  // namespace

void add_self_collide(py::module_& module) {
  py::class_<SelfFilter>(module, "SelfFilter")
      .def(py::init(&make_filter), py::arg("model"), py::arg("rings"), py::arg("takes_part"),
           py::arg("at_rest"), py::arg("always"), py::arg("joint_bodies"), py::arg("joint_parents"),
           py::arg("joint_pairs"), py::arg("joint_pairs_in_zones"), py::arg("zones"),
           py::arg("groups"), py::arg("group_pairs"))
      .def("kept_pairs", &kept_pairs, py::arg("pairs"));
  module.def("self_collide", &all_self_contacts, py::arg("poses"), py::arg("ignore"),
             py::arg("max_contacts"), py::arg("run"));
  module.def("self_collide_moving", &all_self_moving, py::arg("poses"), py::arg("ignore"),
             py::arg("leave_out_start"), py::arg("times"), py::arg("max_contacts"), py::arg("run"));
}

}  // namespace pelt::python
