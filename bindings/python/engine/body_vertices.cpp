#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pelt::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Frames that are posed together: the pose directions of SMPL-H are 60 MB of memory, which must be
/// read once for each block.
constexpr std::size_t kFramesPosedTogether = 8;
using Lanes = std::array<double, kFramesPosedTogether>;

/// A body model of the SMPL family, and the poses of all frames. Views of arrays of Python.
struct BodyArrays {
  std::size_t vertices, features, joints, frames;
  const double* rest;        // [V][3]
  const double* directions;  // [V][3][P]
  const double* pose;        // [F][P]
  const double* palettes;    // [F][J][12]
};

struct JointWeight {
  std::size_t joint;
  double weight;
};

/// The weights of each vertex other than 0.
class SparseWeights {
 public:
  SparseWeights(const double* weights, std::size_t vertices, std::size_t joints) {
    for (std::size_t v = 0; v < vertices; ++v) {
      begin_.push_back(all_.size());
      for (std::size_t j = 0; j < joints; ++j)
        if (weights[v * joints + j] != 0) all_.push_back({j, weights[v * joints + j]});
    }
    begin_.push_back(all_.size());
  }

  std::span<const JointWeight> of(std::size_t vertex) const {
    return std::span(all_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<JointWeight> all_;
};

/// The pose features of a block that are not 0 in all of its frames.
struct BlockFeatures {
  std::vector<std::size_t> numbers;
  std::vector<Lanes> values;

  BlockFeatures(const BodyArrays& body, std::size_t first, std::size_t count) {
    for (std::size_t p = 0; p < body.features; ++p) {
      Lanes lanes = {};
      for (std::size_t f = 0; f < count; ++f) lanes[f] = body.pose[(first + f) * body.features + p];
      if (std::all_of(lanes.begin(), lanes.end(), [](double x) { return x == 0; })) continue;
      numbers.push_back(p);
      values.push_back(lanes);
    }
  }

  /// Returns a coordinate of a corrected vertex in the frames of the block.
  Lanes corrected(double rest, const double* directions) const {
    Lanes sum;
    sum.fill(rest);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double direction = directions[numbers[i]];
      for (std::size_t f = 0; f < kFramesPosedTogether; ++f) sum[f] += direction * values[i][f];
    }
    return sum;
  }
};

std::array<double, 12> blended(const double* palette, std::span<const JointWeight> influences) {
  std::array<double, 12> sum = {};
  for (const auto& [joint, weight] : influences)
    for (std::size_t e = 0; e < 12; ++e) sum[e] += weight * palette[12 * joint + e];
  return sum;
}

void pose_block(const BodyArrays& body, const SparseWeights& influences, std::size_t first,
                std::size_t count, float* out) {
  const BlockFeatures features(body, first, count);
  for (std::size_t v = 0; v < body.vertices; ++v) {
    std::array<Lanes, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] = features.corrected(body.rest[3 * v + axis],
                                    body.directions + (3 * v + axis) * body.features);
    for (std::size_t f = 0; f < count; ++f) {
      const auto m = blended(body.palettes + (first + f) * 12 * body.joints, influences.of(v));
      float* const vertex = out + ((first + f) * body.vertices + v) * 3;
      for (std::size_t row = 0; row < 3; ++row)
        vertex[row] = static_cast<float>(m[4 * row] * at[0][f] + m[4 * row + 1] * at[1][f] +
                                         m[4 * row + 2] * at[2][f] + m[4 * row + 3]);
    }
  }
}

/// Returns the vertices [F, V, 3] of a body model: rest positions and pose directions times pose
/// features, then linear blend skinning, in double precision. A frame does not depend on others.
py::array_t<float> body_vertices(const Doubles& rest, const Doubles& directions,
                                 const Doubles& weights, const Doubles& pose,
                                 const Doubles& palettes, const Run& run) {
  check_shape(rest, "rest", {-1, 3}, "[V, 3]");
  check_shape(pose, "pose", {-1, -1}, "[F, P]");
  check_shape(weights, "weights", {rest.shape(0), -1}, "[V, J]");
  check_shape(directions, "directions", {rest.shape(0), 3, pose.shape(1)}, "[V, 3, P]");
  check_shape(palettes, "palettes", {pose.shape(0), weights.shape(1), 12}, "[F, J, 12]");
  const auto size = [](py::ssize_t count) { return static_cast<std::size_t>(count); };
  const BodyArrays body = {size(rest.shape(0)), size(pose.shape(1)), size(weights.shape(1)),
                           size(pose.shape(0)), rest.data(),         directions.data(),
                           pose.data(),         palettes.data()};
  const SparseWeights influences(weights.data(), body.vertices, body.joints);
  py::array_t<float> result = new_array<float>({body.frames, body.vertices, 3});
  float* const out = result.mutable_data();
  run_frames((body.frames + kFramesPosedTogether - 1) / kFramesPosedTogether, run,
             [&](FrameQueue& queue) {
               while (const auto block = queue.next()) {
                 const std::size_t first = *block * kFramesPosedTogether;
                 pose_block(body, influences, first,
                            std::min(kFramesPosedTogether, body.frames - first), out);
               }
             });
  return result;
}

}  // namespace

void add_body_vertices(py::module_& module) {
  module.def("body_vertices", &body_vertices, py::arg("rest"), py::arg("directions"),
             py::arg("weights"), py::arg("pose"), py::arg("palettes"), py::arg("run"));
}

}  // namespace pelt::python
