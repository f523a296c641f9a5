#include "bindings/python/engine/clip_poses.hpp"

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <utility>

namespace pelt::python {

namespace {

/// Returns the number of frames of an array with frames as the first axis.
std::size_t count_frames(const py::array& array, const std::string& name) {
  if (array.shape(0) == 0) throw ArgumentError(name + ": there are no frames");
  return static_cast<std::size_t>(array.shape(0));
}

/// The matrix with these three rows. Faster to pass on than a Matrix3x4, which is converted to
/// columns twice.
Matrix4 from_rows(const float* rows) {
  Matrix4 matrix;
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) matrix.m[4 * column + row] = rows[4 * row + column];
    matrix.m[4 * column + 3] = column == 3 ? 1 : 0;
  }
  return matrix;
}

std::string list_of(std::size_t first, const char* others) {
  return "[F, " + std::to_string(first) + others;
}

/// Throws the error of a result, with remedies as Python spells them.
void check_in_python(Result<void> result, const std::string& place) {
  if (result) return;
  std::string message = result.error().message;
  const std::pair<std::string, std::string> remedies[] = {
      {"ModelOptions::weld = false", "pelt.Model(..., weld=False)"},
      {"set SkinnedMeshView::offset_caps", "give pelt.Model offset_caps"}};
  for (const auto& [library, python] : remedies)
    if (const std::size_t at = message.find(library); at != std::string::npos)
      message.replace(at, library.size(), python);
  throw ArgumentError(place + ": " + message);
}

}  // namespace

ClipPoses ClipPoses::of_palettes(const SkinnedModel& model, std::string name,
                                 const py::array& palettes,
                                 const std::optional<py::array>& morph_weights,
                                 const std::optional<py::array>& offsets) {
  const std::size_t joints = model.joint_count();
  const bool has_rows = palettes.ndim() == 4 && (palettes.shape(2) == 3 || palettes.shape(2) == 4);
  check_shape(palettes, name, {-1, static_cast<py::ssize_t>(joints), has_rows ? -1 : 4, 4},
              list_of(joints, ", 4, 4] or ") + list_of(joints, ", 3, 4]"));
  const std::size_t frame_count = count_frames(palettes, name);
  ClipPoses poses(model, std::move(name), frame_count);
  poses.palettes_.emplace(palettes, poses.name_);
  const auto frames = static_cast<py::ssize_t>(poses.frame_count_);
  if (offsets) {
    const auto vertices = static_cast<py::ssize_t>(model.vertex_count());
    check_shape(*offsets, poses.name_ + ", offsets", {frames, vertices, 3},
                "[" + std::to_string(frames) + ", " + std::to_string(vertices) + ", 3]");
    poses.offsets_.emplace(*offsets, poses.name_ + ", offsets");
  }
  if (!morph_weights) return poses;
  const auto targets = static_cast<py::ssize_t>(model.morph_target_count());
  check_shape(*morph_weights, poses.name_ + ", morph_weights", {frames, targets},
              "[" + std::to_string(frames) + ", " + std::to_string(targets) + "]");
  poses.morph_weights_.emplace(*morph_weights, poses.name_ + ", morph_weights");
  return poses;
}

ClipPoses ClipPoses::of_vertices(const SkinnedModel& model, std::string name,
                                 const py::array& vertices) {
  const std::size_t count = model.vertex_count();
  check_shape(vertices, name, {-1, static_cast<py::ssize_t>(count), 3}, list_of(count, ", 3]"));
  const std::size_t frame_count = count_frames(vertices, name);
  ClipPoses poses(model, std::move(name), frame_count);
  poses.vertices_.emplace(vertices, poses.name_);
  return poses;
}

std::string ClipPoses::place(std::size_t frame) const {
  return frame_count_ == 1 ? name_ : name_ + ", frame " + std::to_string(frame);
}

void ClipPoses::set(Pose& pose, std::size_t frame, Memory& memory) const {
  if (vertices_)
    set_vertices(pose, frame, memory);
  else
    set_palette(pose, frame, memory);
}

void ClipPoses::set_palette(Pose& pose, std::size_t frame, Memory& memory) const {
  read_palette(frame, memory);
  if (!pose.set_palette(memory.palette)) {
    // The palette may be invalid only together with the morph weights of an earlier frame.
    pose = Pose(model());
    check(pose.set_palette(memory.palette), place(frame));
  }
  if (morph_weights_) set_morph_weights(pose, frame, memory);
  if (offsets_) set_offsets(pose, frame, memory);
}

void ClipPoses::read_palette(std::size_t frame, Memory& memory) const {
  const std::size_t rows = palettes_->size(2);
  memory.palette.resize(model().joint_count());
  memory.matrices.resize(4 * rows * memory.palette.size());
  palettes_->copy(frame, memory.matrices.data());
  const float* matrix = memory.matrices.data();
  for (std::size_t joint = 0; joint < memory.palette.size(); ++joint, matrix += 4 * rows) {
    if (rows == 4) check_last_row(matrix + 12, frame, joint);
    memory.palette[joint] = from_rows(matrix);
  }
}

void ClipPoses::check_last_row(const float* row, std::size_t frame, std::size_t joint) const {
  if (row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 1) return;
  throw ArgumentError(place(frame) + ": the last row of the matrix of joint " +
                      std::to_string(joint) +
                      " is not 0 0 0 1 (if the matrices are column-major, swap the last two axes)");
}

void ClipPoses::set_morph_weights(Pose& pose, std::size_t frame, Memory& memory) const {
  memory.morph_weights.resize(model().morph_target_count());
  morph_weights_->copy(frame, memory.morph_weights.data());
  check(pose.set_morph_weights(memory.morph_weights), place(frame));
}

void ClipPoses::set_offsets(Pose& pose, std::size_t frame, Memory& memory) const {
  memory.offsets.resize(model().vertex_count());
  offsets_->copy(frame, &memory.offsets.data()->x);
  check_in_python(pose.set_offsets(memory.offsets), place(frame));
  // A clamped offset would answer for another shape than the caller's.
  if (const std::uint32_t clamped = check_offsets(pose); clamped > 0)
    throw ArgumentError(place(frame) + ": the offsets of " + std::to_string(clamped) +
                        " vertices are NaN or beyond the caps of the model (offset_caps)");
}

void ClipPoses::set_vertices(Pose& pose, std::size_t frame, Memory& memory) const {
  read_vertices(frame, memory);
  check_in_python(pose.set_vertices(memory.vertices), place(frame));
}

void ClipPoses::read_vertices(std::size_t frame, Memory& memory) const {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  memory.vertices.resize(model().vertex_count());
  vertices_->copy(frame, &memory.vertices.data()->x);
}

void ClipPoses::set(Crowd& crowd, std::uint32_t instance, std::size_t frame, Memory& memory) const {
  if (vertices_) {
    read_vertices(frame, memory);
    return check_in_python(crowd.set_vertices(instance, memory.vertices), place(frame));
  }
  read_palette(frame, memory);
  if (morph_weights_) {
    // The palette may be invalid only together with the morph weights of an earlier frame.
    memory.morph_weights.assign(model().morph_target_count(), 0);
    check(crowd.set_morph_weights(instance, memory.morph_weights), place(frame));
  }
  check(crowd.set_palette(instance, memory.palette), place(frame));
  if (morph_weights_) {
    morph_weights_->copy(frame, memory.morph_weights.data());
    check(crowd.set_morph_weights(instance, memory.morph_weights), place(frame));
  }
  if (offsets_) set_offsets(crowd, instance, frame, memory);
}

/// A pose checks the offsets, because a crowd does not tell which of them it clamps.
void ClipPoses::set_offsets(Crowd& crowd, std::uint32_t instance, std::size_t frame,
                            Memory& memory) const {
  if (!memory.checked) memory.checked.emplace(model());
  set_offsets(*memory.checked, frame, memory);
  check(crowd.set_offsets(instance, memory.offsets), place(frame));
}

Pose& FramePose::at(std::size_t frame) {
  if (poses_->frame_count() == 1) frame = 0;
  if (frame_ == frame) return pose_;
  frame_.reset();
  poses_->set(pose_, frame, memory_);
  frame_ = frame;
  return pose_;
}

std::size_t common_frame_count(const ClipPoses& a, const ClipPoses& b) {
  const std::size_t of_a = a.frame_count(), of_b = b.frame_count();
  if (of_a == of_b || of_b == 1) return of_a;
  if (of_a == 1) return of_b;
  throw ArgumentError(a.name() + " has " + std::to_string(of_a) + " frames, but " + b.name() +
                      " has " + std::to_string(of_b) + " (expected equal numbers, or one frame)");
}

std::size_t step_count(std::size_t frames) {
  if (frames > 1) return frames - 1;
  throw ArgumentError("a motion needs at least two frames, found one");
}

namespace {

/// Returns the posed vertices [F, V, 3].
py::array_t<float> all_posed_vertices(const ClipPoses& poses, const Run& run) {
  const std::size_t frames = poses.frame_count(), vertices = poses.model().vertex_count();
  py::array_t<float> result = new_array<float>({frames, vertices, 3});
  Vec3* const out = reinterpret_cast<Vec3*>(result.mutable_data());
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    while (const auto frame = queue.next())
      posed_vertices(pose.at(*frame), std::span(out + *frame * vertices, vertices));
  });
  return result;
}

}  // namespace

void add_poses(py::module_& module) {
  py::class_<Run>(module, "Run")
      .def(py::init<std::uint32_t, py::object>(), py::arg("threads"), py::arg("on_progress"));
  py::class_<ClipPoses>(module, "ClipPoses")
      .def_static("of_palettes", &ClipPoses::of_palettes, py::arg("model"), py::arg("name"),
                  py::arg("palettes"), py::arg("morph_weights"), py::arg("offsets"))
      .def_static("of_vertices", &ClipPoses::of_vertices, py::arg("model"), py::arg("name"),
                  py::arg("vertices"))
      .def_property_readonly("frame_count", &ClipPoses::frame_count);
  module.def("posed_vertices", &all_posed_vertices, py::arg("poses"), py::arg("run"));
}

}  // namespace pelt::python
