#include <pelt/model.hpp>
#include <pelt/surface.hpp>

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/bindings.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

namespace pelt::python {
namespace {

/// kNoJoint is not a joint.
constexpr std::size_t kMaxJoints = 65'535;

/// (joint, weight) pairs of all vertices. Empty for a mesh without joints.
struct Influences {
  std::uint32_t per_vertex = 1;
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  std::uint32_t joint_count = 0;
};

/// The arrays of a morph target without zero displacements.
struct Morphs {
  std::vector<std::uint32_t> begin, vertices;
  std::vector<Vec3> displacements;

  MorphTargetsView view() const { return {begin, vertices, displacements}; }
};

std::vector<Vec3> read_rest(const py::array& rest) {
  check_shape(rest, "rest", {-1, 3}, "[V, 3]");
  const FloatView view(rest, "rest");
  std::vector<Vec3> positions(view.size(0));
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = {view.at(v, 0), view.at(v, 1), view.at(v, 2)};
  return positions;
}

std::vector<Triangle> read_faces(const Integers& faces, std::size_t vertices) {
  check_shape(faces, "faces", {-1, 3}, "[T, 3]");
  const auto indices = indices_of<std::uint32_t>(faces, "faces", vertices);
  std::vector<Triangle> triangles(indices.size() / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    triangles[t] = {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
  return triangles;
}

std::uint32_t check_joint_count(std::size_t count) {
  if (count >= 1 && count <= kMaxJoints) return static_cast<std::uint32_t>(count);
  throw ArgumentError("weights: expected 1 to 65535 joints, found " + std::to_string(count));
}

/// Drops the zeros of dense weights [V, J].
Influences read_dense(const py::array& weights, std::size_t vertices) {
  check_shape(weights, "weights", {static_cast<py::ssize_t>(vertices), -1},
              "[" + std::to_string(vertices) + ", J]");
  const FloatView view(weights, "weights");
  Influences result = {1, {}, {}, check_joint_count(view.size(1))};
  for (std::size_t v = 0; v < vertices; ++v) {
    std::uint32_t used = 0;
    for (std::size_t j = 0; j < view.size(1); ++j) used += view.at(v, j) != 0;
    result.per_vertex = std::max(result.per_vertex, used);
  }
  result.joints.resize(vertices * result.per_vertex);
  result.weights.resize(vertices * result.per_vertex);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::size_t place = v * result.per_vertex;
    const std::size_t end = place + result.per_vertex;
    for (std::size_t j = 0; j < view.size(1) && place < end; ++j) {
      const float weight = view.at(v, j);
      if (weight == 0) continue;
      result.joints[place] = static_cast<std::uint16_t>(j);
      result.weights[place++] = weight;
    }
  }
  return result;
}

/// Reads `weights` [V, K] of the joints [V, K].
Influences read_sparse(const py::array& weights, const Integers& joints, std::size_t vertices,
                       std::optional<std::size_t> joint_count) {
  check_shape(weights, "weights", {static_cast<py::ssize_t>(vertices), -1},
              "[" + std::to_string(vertices) + ", K]");
  check_shape(joints, "joints", {weights.shape(0), weights.shape(1)},
              "[" + std::to_string(vertices) + ", " + std::to_string(weights.shape(1)) + "]");
  const FloatView view(weights, "weights");
  if (view.size(1) == 0) throw ArgumentError("weights: expected at least one joint for a vertex");
  Influences result;
  result.per_vertex = static_cast<std::uint32_t>(view.size(1));
  result.joints = indices_of<std::uint16_t>(joints, "joints", joint_count.value_or(kMaxJoints));
  for (std::size_t v = 0; v < vertices; ++v)
    for (std::size_t k = 0; k < view.size(1); ++k) result.weights.push_back(view.at(v, k));
  const auto greatest = std::max_element(result.joints.begin(), result.joints.end());
  const std::size_t found = greatest == result.joints.end() ? 1 : *greatest + std::size_t{1};
  result.joint_count = check_joint_count(joint_count.value_or(found));
  return result;
}

Influences read_influences(const std::optional<py::array>& weights,
                           const std::optional<Integers>& joints, std::size_t vertices,
                           std::optional<std::size_t> joint_count) {
  if (!weights) return {};
  return joints ? read_sparse(*weights, *joints, vertices, joint_count)
                : read_dense(*weights, vertices);
}

Morphs read_morphs(const std::optional<py::array>& targets, std::size_t vertices) {
  Morphs morphs;
  if (!targets) return morphs;
  check_shape(*targets, "morph_targets", {-1, static_cast<py::ssize_t>(vertices), 3},
              "[M, " + std::to_string(vertices) + ", 3]");
  const FloatView view(*targets, "morph_targets");
  if (view.size(0) == 0) return morphs;
  morphs.begin.push_back(0);
  for (std::size_t m = 0; m < view.size(0); ++m) {
    for (std::size_t v = 0; v < vertices; ++v) {
      const Vec3 displacement = view.vector_at(m, v);
      if (displacement == Vec3{}) continue;
      morphs.vertices.push_back(static_cast<std::uint32_t>(v));
      morphs.displacements.push_back(displacement);
    }
    morphs.begin.push_back(static_cast<std::uint32_t>(morphs.vertices.size()));
  }
  return morphs;
}

std::vector<float> read_caps(const std::optional<py::array>& caps, std::size_t vertices) {
  std::vector<float> result;
  if (!caps) return result;
  check_shape(*caps, "offset_caps", {static_cast<py::ssize_t>(vertices)},
              "[" + std::to_string(vertices) + "]");
  const FloatView view(*caps, "offset_caps");
  for (std::size_t v = 0; v < vertices; ++v) result.push_back(view.at(v));
  return result;
}

/// Reads palettes [S, J, 4, 4] or [S, J, 3, 4].
std::vector<Matrix4> read_samples(const std::optional<py::array>& palettes, std::uint32_t joints) {
  std::vector<Matrix4> samples;
  if (!palettes) return samples;
  const std::string shape = "[S, " + std::to_string(joints) + ", 4, 4]";
  const bool has_three_rows = palettes->ndim() == 4 && palettes->shape(2) == 3;
  check_shape(*palettes, "sample_palettes",
              {-1, static_cast<py::ssize_t>(joints), has_three_rows ? 3 : 4, 4}, shape);
  const FloatView view(*palettes, "sample_palettes");
  for (std::size_t s = 0; s < view.size(0); ++s) {
    for (std::size_t joint = 0; joint < joints; ++joint) {
      Matrix4& matrix = samples.emplace_back();
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column)
          matrix.m[4 * column + row] = view.at(s, joint, row, column);
    }
  }
  return samples;
}

/// Answers number triangles with 32 bits and a sign.
void check_counts(std::size_t vertices, std::size_t triangles) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (vertices > kMost || triangles > kMost)
    throw ArgumentError("faces: expected at most 2147483647 vertices and triangles");
}

SkinnedModel make_model(const py::array& rest, const Integers& faces,
                        const std::optional<py::array>& weights,
                        const std::optional<Integers>& joints,
                        std::optional<std::size_t> joint_count,
                        const std::optional<py::array>& morph_targets,
                        const std::optional<py::array>& offset_caps, bool renormalise, bool weld,
                        const std::optional<py::array>& sample_palettes) {
  const std::vector<Vec3> positions = read_rest(rest);
  check_counts(positions.size(), static_cast<std::size_t>(faces.size()) / 3);
  const std::vector<Triangle> triangles = read_faces(faces, positions.size());
  const Influences influences = read_influences(weights, joints, positions.size(), joint_count);
  const Morphs morphs = read_morphs(morph_targets, positions.size());
  const std::vector<float> caps = read_caps(offset_caps, positions.size());
  const std::vector<Matrix4> samples =
      read_samples(sample_palettes, std::max(1U, influences.joint_count));
  const SkinnedMeshView mesh = {positions,
                                triangles,
                                influences.per_vertex,
                                influences.joints,
                                influences.weights,
                                influences.joint_count,
                                morphs.view(),
                                caps};
  const py::gil_scoped_release unlocked;
  ModelOptions options;
  if (renormalise) options.off_weights = OffWeights::renormalise;
  options.weld = weld;
  options.sample_palettes = samples;
  return SkinnedModel(value_of(build_model(mesh, options), "Model"));
}

py::bytes bytes_of(const SkinnedModel& model) {
  const std::vector<std::byte> bytes = save_model(model);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

SkinnedModel model_of(const py::bytes& bytes) {
  const std::string_view text = bytes;
  const py::gil_scoped_release unlocked;
  return SkinnedModel(
      value_of(load_model(std::as_bytes(std::span(text.data(), text.size()))), "from_bytes"));
}

py::dict report_of(const SkinnedModel& model) {
  const BuildReport& report = model.report();
  py::dict result;
  result["renormalised_vertices"] = report.renormalised_vertices;
  result["merged_influences"] = report.merged_influences;
  result["degenerate_triangles"] = report.degenerate_triangles;
  return result;
}

bool is_closed(const SkinnedModel& model) {
  const py::gil_scoped_release unlocked;
  return model.surface().is_closed();
}

}  // namespace

void add_model(py::module_& module) {
  py::class_<SkinnedModel>(module, "Model")
      .def(py::init(&make_model), py::arg("rest"), py::arg("faces"), py::arg("weights"),
           py::arg("joints"), py::arg("joint_count"), py::arg("morph_targets"),
           py::arg("offset_caps"), py::arg("renormalise"), py::arg("weld"),
           py::arg("sample_palettes"))
      .def_static("from_bytes", &model_of, py::arg("data"))
      .def("to_bytes", &bytes_of)
      .def_property_readonly("vertex_count", [](const SkinnedModel& m) { return m.vertex_count(); })
      .def_property_readonly("triangle_count",
                             [](const SkinnedModel& m) { return m.triangle_count(); })
      .def_property_readonly("joint_count", [](const SkinnedModel& m) { return m.joint_count(); })
      .def_property_readonly("morph_target_count",
                             [](const SkinnedModel& m) { return m.morph_target_count(); })
      .def_property_readonly("memory_bytes", [](const SkinnedModel& m) { return m.memory_bytes(); })
      .def_property_readonly("report", &report_of)
      .def_property_readonly("is_closed", &is_closed);
}

}  // namespace pelt::python
