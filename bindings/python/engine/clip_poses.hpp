#pragma once

/// The poses of a model in all frames of a call.

#include <pelt/crowd.hpp>
#include <pelt/math.hpp>
#include <pelt/model.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/self_filter.hpp>

#include "bindings/python/engine/array_view.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pelt::python {

/// Poses of one model in F frames, as arrays of NumPy that are read when a frame is needed.
class ClipPoses {
 public:
  /// `name`: of the argument, for messages.
  /// `palettes`: [F, J, 4, 4] or [F, J, 3, 4].
  /// `morph_weights`: [F, M], or nothing.
  /// `offsets`: of vertices [F, V, 3], or nothing.
  static ClipPoses of_palettes(const SkinnedModel& model, std::string name,
                               const py::array& palettes,
                               const std::optional<py::array>& morph_weights,
                               const std::optional<py::array>& offsets);

  /// `vertices`: [F, V, 3] positions of all vertices, in place of palettes.
  static ClipPoses of_vertices(const SkinnedModel& model, std::string name,
                               const py::array& vertices);

  const SkinnedModel& model() const { return model_; }
  const std::string& name() const { return name_; }
  std::size_t frame_count() const { return frame_count_; }

  /// Working memory of `set`.
  struct Memory {
    std::vector<float> matrices;  // row by row
    std::vector<Matrix4> palette;
    std::vector<float> morph_weights;
    std::vector<Vec3> vertices;
    std::vector<Vec3> offsets;    // borrowed by the pose or the instance
    std::optional<Pose> checked;  // of an instance with offsets
  };

  /// Sets the pose to a frame. Throws an error with the name and the frame if an element is
  /// invalid. `memory` must outlive the queries of the pose.
  void set(Pose& pose, std::size_t frame, Memory& memory) const;

  /// Sets an instance of a crowd to a frame. Throws like `set` of a pose. `memory` belongs to the
  /// instance and must outlive the queries of the crowd.
  void set(Crowd& crowd, std::uint32_t instance, std::size_t frame, Memory& memory) const;

 private:
  ClipPoses(SkinnedModel model, std::string name, std::size_t frame_count)
      : model_(std::move(model)), name_(std::move(name)), frame_count_(frame_count) {}

  std::string place(std::size_t frame) const;
  void set_palette(Pose& pose, std::size_t frame, Memory& memory) const;
  void read_palette(std::size_t frame, Memory& memory) const;
  void read_vertices(std::size_t frame, Memory& memory) const;
  void check_last_row(const float* row, std::size_t frame, std::size_t joint) const;
  void set_morph_weights(Pose& pose, std::size_t frame, Memory& memory) const;
  void set_offsets(Pose& pose, std::size_t frame, Memory& memory) const;
  void set_offsets(Crowd& crowd, std::uint32_t instance, std::size_t frame, Memory& memory) const;
  void set_vertices(Pose& pose, std::size_t frame, Memory& memory) const;

  SkinnedModel model_;
  std::string name_;
  std::size_t frame_count_;
  std::optional<FloatView> palettes_, morph_weights_, offsets_;  // either palettes
  std::optional<FloatView> vertices_;                            // or vertices
};

/// A pose that one thread moves from frame to frame.
class FramePose {
 public:
  explicit FramePose(const ClipPoses& poses) : poses_(&poses), pose_(poses.model()) {}

  /// The pose in a frame. Nodes that are open stay open if the frame is the same as before.
  Pose& at(std::size_t frame);

 private:
  const ClipPoses* poses_;
  Pose pose_;
  std::optional<std::size_t> frame_;  // that `pose_` is set to
  ClipPoses::Memory memory_;
};

/// Steps from one frame to the next, for one thread.
class FrameMotion {
 public:
  explicit FrameMotion(const ClipPoses& poses) : ends_{FramePose(poses), FramePose(poses)} {}

  /// The step from frame `step` to the next. The poses of consecutive steps are used again.
  Motion at(std::size_t step) {
    return {ends_[step % 2].at(step), ends_[(step + 1) % 2].at(step + 1)};
  }

 private:
  std::array<FramePose, 2> ends_;
};

/// Number of frames of a call with two clips: both have as many, or one of them has one. Otherwise
/// throws an error with both names.
std::size_t common_frame_count(const ClipPoses& a, const ClipPoses& b);

/// Number of steps between `frames` frames. Throws an error if there is only one frame.
std::size_t step_count(std::size_t frames);

/// Throws an error that starts with `name` if a filter was made for another model, which would end
/// the program.
inline void check_model(const ClipPoses& poses, const SelfFilter& filter, const std::string& name) {
  if (&filter.model().detail() != &poses.model().detail())
    throw ArgumentError(name + ": the filter was made for another model");
}

}  // namespace pelt::python
