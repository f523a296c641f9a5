#include "asset/primitive.hpp"

#include "text/message.hpp"

#include <numeric>

namespace pelt::asset {

namespace {

std::vector<Vec3> to_points(const std::vector<float>& values) {
  std::vector<Vec3> points(values.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  }
  return points;
}

std::size_t triangle_count(PrimitiveMode mode, std::size_t corner_count) {
  if (mode == PrimitiveMode::triangles) return corner_count / 3;
  return corner_count < 3 ? 0 : corner_count - 2;
}

/// Returns the corners of triangle `i` as indices into the list of corners (glTF 2.0,
/// section 3.7.2.1).
std::array<std::size_t, 3> corners_of(PrimitiveMode mode, std::size_t i) {
  if (mode == PrimitiveMode::triangles) return {3 * i, 3 * i + 1, 3 * i + 2};
  if (mode == PrimitiveMode::strip) return {i, i + 1 + i % 2, i + 2 - i % 2};
  return {i + 1, i + 2, 0};
}

}  // namespace

std::string primitive_label(const GltfDocument& document, PrimitivePlace place) {
  return text::label("mesh", place.mesh, document.meshes[place.mesh].name) + ", " +
         text::label("primitive", place.primitive);
}

PrimitiveReader::PrimitiveReader(const GltfDocument& document, AccessorReader& reader,
                                 Budget& budget)
    : document_(document), reader_(reader), budget_(budget) {}

Result<std::vector<Vec3>> PrimitiveReader::positions(PrimitivePlace place) {
  const Result<std::vector<float>> values =
      reader_.floats(*at(place).positions, ElementType::vec3, Storage::floats_or_integers,
                     "POSITION of " + label_of(place));
  if (!values) return values.error();
  return to_points(*values);
}

Result<std::vector<Vec3>> PrimitiveReader::displacements(PrimitivePlace place, std::uint32_t target,
                                                         std::uint64_t vertex_count) {
  const auto& targets = at(place).target_positions;
  if (target >= targets.size() || !targets[target]) return std::vector<Vec3>();
  const std::uint32_t accessor = *targets[target];
  const std::string use =
      "POSITION of morph target " + std::to_string(target) + " of " + label_of(place);
  const Result<void> same_count = require_count(accessor, vertex_count, use);
  if (!same_count) return same_count.error();
  const Result<std::vector<float>> values =
      reader_.floats(accessor, ElementType::vec3, Storage::floats_or_integers, use);
  if (!values) return values.error();
  return to_points(*values);
}

Result<Influences> PrimitiveReader::influences(PrimitivePlace place,
                                               const std::vector<std::uint16_t>& joints,
                                               const std::string& skin) {
  const std::size_t set_count = at(place).influence_sets.size();
  if (set_count == 0) {
    return text::malformed(label_of(place) + ": has no JOINTS_0, but is moved by " + skin);
  }
  std::vector<std::vector<std::uint32_t>> joint_sets;
  std::vector<std::vector<float>> weight_sets;
  for (std::uint32_t set = 0; set < set_count; ++set) {
    Result<std::vector<std::uint32_t>> indices = joint_set(place, set, joints.size(), skin);
    if (!indices) return indices.error();
    Result<std::vector<float>> weights = weight_set(place, set);
    if (!weights) return weights.error();
    joint_sets.push_back(*std::move(indices));
    weight_sets.push_back(*std::move(weights));
  }
  Influences influences;
  const std::size_t vertex_count = weight_sets[0].size() / 4;
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    for (std::size_t slot = 0; slot < 4 * set_count; ++slot) {
      const std::size_t set = slot / 4, i = 4 * vertex + slot % 4;
      if (weight_sets[set][i] == 0) continue;
      influences.list.push_back({joints[joint_sets[set][i]], weight_sets[set][i]});
    }
    influences.first.push_back(influences.list.size());
  }
  return influences;
}

Result<std::vector<std::uint32_t>> PrimitiveReader::joint_set(PrimitivePlace place,
                                                              std::uint32_t set,
                                                              std::size_t joint_count,
                                                              const std::string& skin) {
  const std::uint32_t accessor = at(place).influence_sets[set].joints;
  const std::string use = "JOINTS_" + std::to_string(set) + " of " + label_of(place);
  const Result<void> same_count = require_count(accessor, reader_.count(*at(place).positions), use);
  if (!same_count) return same_count.error();
  Result<std::vector<std::uint32_t>> indices =
      reader_.integers(accessor, ElementType::vec4, ComponentType::u16, use);
  if (!indices) return indices;
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const std::uint32_t joint = (*indices)[i];
    if (joint < joint_count) continue;
    return text::malformed(accessor_label(accessor, use) + ": vertex " + std::to_string(i / 4) +
                           " refers to joint " + std::to_string(joint) + ", but " + skin + " has " +
                           std::to_string(joint_count) + " joints");
  }
  return indices;
}

Result<std::vector<float>> PrimitiveReader::weight_set(PrimitivePlace place, std::uint32_t set) {
  const std::uint32_t accessor = at(place).influence_sets[set].weights;
  const std::string use = "WEIGHTS_" + std::to_string(set) + " of " + label_of(place);
  const Result<void> same_count = require_count(accessor, reader_.count(*at(place).positions), use);
  if (!same_count) return same_count.error();
  return reader_.floats(accessor, ElementType::vec4, Storage::floats_or_normalised, use);
}

Result<std::vector<Triangle>> PrimitiveReader::triangles(PrimitivePlace place,
                                                         std::uint64_t vertex_count) {
  const PrimitiveMode mode = at(place).mode;
  const Result<std::vector<std::uint32_t>> list = corners(place, vertex_count);
  if (!list) return list.error();
  if (mode == PrimitiveMode::triangles && list->size() % 3 != 0) {
    return text::malformed(label_of(place) + ": " + std::to_string(list->size()) +
                           " vertices are not a whole number of triangles");
  }
  std::vector<Triangle> triangles(triangle_count(mode, list->size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<std::size_t, 3> corner = corners_of(mode, i);
    triangles[i] = {(*list)[corner[0]], (*list)[corner[1]], (*list)[corner[2]]};
  }
  return triangles;
}

/// Returns the vertices in the order in which the primitive draws them.
Result<std::vector<std::uint32_t>> PrimitiveReader::corners(PrimitivePlace place,
                                                            std::uint64_t vertex_count) {
  if (!at(place).indices) {
    const Result<void> taken = budget_.take(vertex_count, 4, label_of(place));
    if (!taken) return taken.error();
    std::vector<std::uint32_t> all(vertex_count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  const std::string use = "indices of " + label_of(place);
  Result<std::vector<std::uint32_t>> indices =
      reader_.integers(*at(place).indices, ElementType::scalar, ComponentType::u32, use);
  if (!indices) return indices;
  for (std::size_t i = 0; i < indices->size(); ++i) {
    if ((*indices)[i] < vertex_count) continue;
    return text::malformed(accessor_label(*at(place).indices, use) + ": index " +
                           std::to_string(i) + " is " + std::to_string((*indices)[i]) +
                           ", but there are " + std::to_string(vertex_count) + " vertices");
  }
  return indices;
}

Result<void> PrimitiveReader::require_count(std::uint32_t accessor, std::uint64_t vertex_count,
                                            const std::string& use) const {
  if (reader_.count(accessor) == vertex_count) return {};
  return text::malformed(accessor_label(accessor, use) + ": has " +
                         std::to_string(reader_.count(accessor)) + " elements for " +
                         std::to_string(vertex_count) + " vertices");
}

const GltfPrimitive& PrimitiveReader::at(PrimitivePlace place) const {
  return document_.meshes[place.mesh].primitives[place.primitive];
}

std::string PrimitiveReader::label_of(PrimitivePlace place) const {
  return primitive_label(document_, place);
}

}  // namespace pelt::asset
