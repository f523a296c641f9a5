#include "tools/pelt/posed_instances.hpp"

#include <pelt/pose.hpp>

#include "asset/message.hpp"
#include "base/vec3.hpp"
#include "tools/pelt/scene_query.hpp"

#include <cmath>
#include <map>

namespace pelt::tools {
namespace {

using detail::Vec3d;

/// What the instances take in a .glb, positions, normals and indices: its sizes are 32 bits wide.
Result<void> check_glb_size(const scenes::Scene& scene) {
  constexpr std::uint64_t kMost = 0xF0000000;
  std::uint64_t bytes = 0;
  for (const scenes::Instance& instance : scene.instances) {
    const asset::Asset& asset = scene.characters[instance.character].asset;
    bytes += 24 * asset.rest_positions.size() + 12 * asset.triangles.size();
  }
  if (bytes <= kMost) return {};
  return Error{ErrorCode::unsupported,
               scene.name + ": its posed characters take " + std::to_string(bytes >> 20) +
                   " MiB, more than a .glb can hold: make scenes of fewer instances"};
}

/// Without sample poses: nothing is asked of these models but posed vertices.
Result<std::vector<SkinnedModel>> build_models(const scenes::Scene& scene,
                                               const ModelArguments& arguments) {
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene.characters) {
    Result<SkinnedModel> model =
        build_named_model(character.source, character.asset.mesh(), arguments);
    if (!model) return model.error();
    models.push_back(std::move(*model));
  }
  return models;
}

Result<std::vector<Vec3>> pose_vertices(const SkinnedModel& model, std::span<const Matrix4> palette,
                                        std::span<const float> morph_weights) {
  Pose pose(model);
  if (const auto morphed = pose.set_morph_weights(morph_weights); !morphed) return morphed.error();
  if (const auto posed = pose.set_palette(palette); !posed) return posed.error();
  std::vector<Vec3> positions(model.vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// For each position, the first vertex at the same place.
std::vector<std::uint32_t> first_at_place(std::span<const Vec3> positions) {
  std::map<std::array<float, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Vec3& p = positions[v];
    result.push_back(first.try_emplace({p.x, p.y, p.z}, v).first->second);
  }
  return result;
}

Vec3 unit(const Vec3d& v) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0)) return {0, 1, 0};
  return {static_cast<float>(v.x / length), static_cast<float>(v.y / length),
          static_cast<float>(v.z / length)};
}

}  // namespace

Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const ModelArguments& arguments) {
  if (const Result<void> fits = check_glb_size(scene); !fits) return fits.error();
  const Result<std::vector<SkinnedModel>> models = build_models(scene, arguments);
  if (!models) return models.error();
  asset::SampleScratch scratch;
  Palettes palettes;
  sample_palettes(scene, frame, scratch, palettes);
  std::vector<PosedInstance> posed;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t c = scene.instances[i].character;
    Result<std::vector<Vec3>> positions =
        pose_vertices((*models)[c], palettes[i], palettes.morphs[i]);
    if (!positions) {
      return asset::prefixed("instances[" + std::to_string(i) + "]", positions.error());
    }
    posed.push_back({scene.characters[c].name + " " + std::to_string(i), std::move(*positions),
                     scene.characters[c].asset.triangles});
  }
  return posed;
}

std::vector<Vec3> smooth_normals(std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles) {
  const std::vector<std::uint32_t> place = first_at_place(positions);
  std::vector<Vec3d> sums(positions.size(), Vec3d(0, 0, 0));
  for (const Triangle& t : triangles) {
    const Vec3d a(positions[t[0]]), b(positions[t[1]]), c(positions[t[2]]);
    const Vec3d twice_area = cross(b - a, c - a);
    for (const std::uint32_t v : t) sums[place[v]] = sums[place[v]] + twice_area;
  }
  std::vector<Vec3> normals;
  for (std::size_t v = 0; v < positions.size(); ++v) normals.push_back(unit(sums[place[v]]));
  return normals;
}

}  // namespace pelt::tools
