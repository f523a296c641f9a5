#include <pelt/crowd.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/frame_lists.hpp"
#include "bindings/python/engine/index_arrays.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace pelt::python {
namespace {

using Column = py::array_t<std::int32_t>;
using Clips = std::vector<ClipPoses>;

/// Frame, character and triangle of a, character and triangle of b [N].
using CrowdColumns = std::tuple<Column, Column, Column, Column, Column>;

/// Number of frames of the clips: all have as many, or one.
std::size_t common_frame_count(const Clips& clips) {
  std::size_t frames = 1;
  const ClipPoses* longest = nullptr;
  for (const ClipPoses& clip : clips) {
    if (clip.frame_count() == 1) continue;
    if (longest && clip.frame_count() != frames)
      throw ArgumentError(longest->name() + " has " + std::to_string(frames) + " frames, but " +
                          clip.name() + " has " + std::to_string(clip.frame_count()) +
                          " (expected equal numbers, or one frame)");
    frames = clip.frame_count();
    longest = &clip;
  }
  return frames;
}

/// The crowd of one thread.
class FrameCrowd {
 public:
  explicit FrameCrowd(const Clips& clips) : clips_(clips), memories_(clips.size()) {
    for (const ClipPoses& clip : clips) crowd_.add(clip.model());
  }

  /// The crowd in a frame. Characters with a single frame are posed once.
  Crowd& at(std::size_t frame) {
    for (std::uint32_t i = 0; i < clips_.size(); ++i)
      if (is_first_ || clips_[i].frame_count() > 1)
        clips_[i].set(crowd_, i, clips_[i].frame_count() == 1 ? 0 : frame, memories_[i]);
    is_first_ = false;
    return crowd_;
  }

 private:
  const Clips& clips_;
  Crowd crowd_;
  std::vector<ClipPoses::Memory> memories_;  // by character
  bool is_first_ = true;
};

/// Which pairs of characters are tested.
class TestedPairs {
 public:
  explicit TestedPairs(std::vector<CrowdPair> pairs) : pairs_(std::move(pairs)) {
    for (CrowdPair& pair : pairs_)
      if (pair.instance_a > pair.instance_b) std::swap(pair.instance_a, pair.instance_b);
    std::sort(pairs_.begin(), pairs_.end());
  }

  bool contains(std::uint32_t a, std::uint32_t b) const {
    return std::binary_search(pairs_.begin(), pairs_.end(), CrowdPair{a, b});
  }

 private:
  std::vector<CrowdPair> pairs_;
};

CrowdColumns columns_of(const FrameLists<CrowdContact>& lists) {
  const std::size_t count = lists.size();
  CrowdColumns columns = {new_array<std::int32_t>({count}), new_array<std::int32_t>({count}),
                          new_array<std::int32_t>({count}), new_array<std::int32_t>({count}),
                          new_array<std::int32_t>({count})};
  std::int32_t* const frames = std::get<0>(columns).mutable_data();
  std::int32_t* const characters_a = std::get<1>(columns).mutable_data();
  std::int32_t* const triangles_a = std::get<2>(columns).mutable_data();
  std::int32_t* const characters_b = std::get<3>(columns).mutable_data();
  std::int32_t* const triangles_b = std::get<4>(columns).mutable_data();
  lists.for_each([&](std::size_t place, std::size_t frame, const CrowdContact& contact) {
    frames[place] = static_cast<std::int32_t>(frame);
    characters_a[place] = static_cast<std::int32_t>(contact.instance_a);
    triangles_a[place] = static_cast<std::int32_t>(contact.triangle_a);
    characters_b[place] = static_cast<std::int32_t>(contact.instance_b);
    triangles_b[place] = static_cast<std::int32_t>(contact.triangle_b);
  });
  return columns;
}

using Filters = std::vector<const SelfFilter*>;

/// Precondition: there are no filters, or as many as characters.
void check_filters(const Clips& clips, const Filters& filters) {
  for (std::size_t i = 0; i < filters.size(); ++i)
    if (filters[i]) check_model(clips[i], *filters[i], "self_filters");
}

CrowdColumns all_crowd_contacts(const Clips& clips, const std::optional<Integers>& pairs,
                                const Filters& filters, std::uint32_t max_contacts,
                                const Run& run) {
  check_filters(clips, filters);
  const TestedPairs tested(read_pairs<CrowdPair, std::uint32_t>(pairs, "pairs", clips.size()));
  FrameLists<CrowdContact> lists(common_frame_count(clips));
  // Threads share frames, or the pairs of a frame if there are fewer frames.
  const bool splits_frames = lists.frame_count() < run.threads;
  CrowdOptions options;
  options.threads = splits_frames ? run.threads : 1;
  options.max_contacts = max_contacts;
  if (pairs)
    options.filter = [&](std::uint32_t a, std::uint32_t b) { return tested.contains(a, b); };
  if (!filters.empty()) options.self_filter = [&](std::uint32_t i) { return filters[i]; };
  run_frames(lists.frame_count(), {splits_frames ? 1 : run.threads, run.on_progress},
             [&](FrameQueue& queue) {
               FrameCrowd crowd(clips);
               std::vector<CrowdContact>& list = lists.add_thread();
               while (const auto frame = queue.next()) {
                 const std::size_t begin = list.size();
                 crowd.at(*frame).collide(list, options);
                 lists.set(*frame, list, begin);
               }
             });
  return columns_of(lists);
}

}  // namespace

void add_crowd(py::module_& module) {
  module.def("collide_crowd", &all_crowd_contacts, py::arg("clips"), py::arg("pairs"),
             py::arg("self_filters"), py::arg("max_contacts"), py::arg("run"));
}

}  // namespace pelt::python
