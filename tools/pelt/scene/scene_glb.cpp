#include "tools/pelt/scene/scene_glb.hpp"

#include "scenes/glb_builder.hpp"
#include "scenes/smooth_normals.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <array>
#include <map>

namespace pelt::tools::scene {
namespace {

using nlohmann::ordered_json;
using scenes::GlbBuilder;

void add_mesh(const GlbMesh& mesh, GlbBuilder& glb) {
  ordered_json attributes;
  attributes["POSITION"] = glb.add_positions(mesh.positions);
  if (!mesh.normals.empty()) attributes["NORMAL"] = glb.add_vectors(mesh.normals);
  ordered_json primitives = ordered_json::array();
  for (const GlbPrimitive& primitive : mesh.primitives) {
    primitives.push_back({{"attributes", attributes},
                          {"indices", glb.add_indices(primitive.triangles)},
                          {"material", primitive.material}});
  }
  ordered_json& json = glb.json;
  const std::size_t number = json["meshes"].size();
  json["meshes"].push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
  json["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
  json["scenes"][0]["nodes"].push_back(number);
}

ordered_json material_json(const GlbMaterial& material) {
  const std::array<float, 3>& c = material.base_colour;
  return {{"name", material.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {c[0], c[1], c[2], 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.6}}},
          {"emissiveFactor", material.emissive},
          {"doubleSided", true}};
}

/// Size of the instances in a .glb (positions, normals and indices), whose sizes have 32 bits.
Result<void> check_glb_size(const scenes::Scene& scene) {
  constexpr std::uint64_t kMax = 0xF0000000;
  std::uint64_t bytes = 0;
  for (const scenes::Instance& instance : scene.instances) {
    const asset::Asset& asset = scene.characters[instance.character].asset;
    bytes += 24 * asset.rest_positions.size() + 12 * asset.triangles.size();
  }
  if (bytes <= kMax) return {};
  return Error{ErrorCode::unsupported,
               scene.name + ": the posed characters take " + std::to_string(bytes >> 20) +
                   " MiB, more than a .glb file can contain: use fewer instances"};
}

/// Built without sample poses, because these models only pose vertices.
Result<std::vector<SkinnedModel>> build_models(const scenes::Scene& scene,
                                               const arguments::ModelArguments& arguments) {
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene.characters) {
    Result<SkinnedModel> model =
        arguments::build_named_model(character, character.asset.mesh(), arguments);
    if (!model) return model.error();
    models.push_back(std::move(*model));
  }
  return models;
}

/// Returns for each position the first vertex at the same position.
std::vector<std::uint32_t> first_at_place(std::span<const Vec3> positions) {
  std::map<std::array<float, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Vec3& p = positions[v];
    result.push_back(first.try_emplace({p.x, p.y, p.z}, v).first->second);
  }
  return result;
}

constexpr std::array<std::array<float, 3>, 4> kSkinColours = {{
    {0.10F, 0.25F, 0.33F},  // slate blue
    {0.55F, 0.38F, 0.20F},  // sand
    {0.18F, 0.30F, 0.17F},  // moss
    {0.34F, 0.18F, 0.22F},  // plum
}};

/// One material per skin colour, then the material of triangles in contact.
std::vector<GlbMaterial> materials() {
  std::vector<GlbMaterial> all;
  all.reserve(kSkinColours.size() + 1);
  for (const std::array<float, 3>& colour : kSkinColours) {
    all.push_back({"skin " + std::to_string(all.size()), colour});
  }
  all.push_back({"contact", {1.0F, 0.25F, 0.05F}, {1.0F, 0.20F, 0.03F}});
  return all;
}

constexpr std::size_t kContactMaterial = kSkinColours.size();

std::size_t skin_material(std::size_t instance) { return instance % kSkinColours.size(); }

/// The triangles of one instance, sorted into free ones and those in contact.
struct Sorted {
  std::vector<Triangle> free, touching;
};

Sorted sort_triangles(std::span<const Triangle> triangles, const std::vector<bool>& touching) {
  Sorted sorted;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    (touching[t] ? sorted.touching : sorted.free).push_back(triangles[t]);
  }
  return sorted;
}

}  // namespace

std::vector<std::byte> make_glb(std::span<const GlbMesh> meshes,
                                std::span<const GlbMaterial> materials) {
  GlbBuilder glb;
  for (const GlbMaterial& material : materials)
    glb.json["materials"].push_back(material_json(material));
  for (const GlbMesh& mesh : meshes) add_mesh(mesh, glb);
  return glb.file();
}

Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const arguments::ModelArguments& arguments) {
  if (const Result<void> fits = check_glb_size(scene); !fits) return fits.error();
  const Result<std::vector<SkinnedModel>> models = build_models(scene, arguments);
  if (!models) return models.error();
  asset::SampleScratch scratch;
  Palettes palettes;
  sample_palettes(scene, frame, scratch, palettes);
  std::vector<PosedInstance> posed;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t c = scene.instances[i].character;
    Pose pose((*models)[c]);
    std::vector<Vec3> positions;
    const auto set = pose_vertices(inputs_of_instance(palettes, i), pose, positions);
    if (!set) return in_instance(i, set.error());
    posed.push_back({scene.characters[c].name + " " + std::to_string(i), std::move(positions),
                     scene.characters[c].asset.triangles});
  }
  return posed;
}

std::vector<Vec3> normals_of(const PosedInstance& instance) {
  std::vector<Vec3> normals(instance.positions.size());
  scenes::smooth_normals(instance.positions, instance.triangles, first_at_place(instance.positions),
                         normals);
  return normals;
}

std::array<float, 3> skin_colour(std::size_t instance) {
  return kSkinColours[skin_material(instance)];
}

std::vector<std::byte> posed_glb(std::span<const PosedInstance> instances) {
  std::vector<GlbMesh> meshes;
  for (const PosedInstance& instance : instances) {
    GlbMesh mesh{instance.name, instance.positions, {}, {}};
    mesh.primitives.push_back({instance.triangles, skin_material(meshes.size())});
    meshes.push_back(std::move(mesh));
  }
  return make_glb(meshes, materials());
}

std::vector<std::vector<bool>> touching_triangles(std::span<const PosedInstance> instances,
                                                  std::span<const Collider> colliders,
                                                  const FrameContacts& found) {
  std::vector<std::vector<bool>> touching;
  for (const PosedInstance& instance : instances) {
    touching.emplace_back(instance.triangles.size(), false);
  }
  for (const FrameContacts::Pair& pair : found.pairs) {
    for (const Contact& contact : found.of(pair)) {
      touching[colliders[pair.a].instance][contact.triangle_a] = true;
      touching[colliders[pair.b].instance][contact.triangle_b] = true;
    }
  }
  return touching;
}

std::vector<std::byte> contacts_glb(std::span<const PosedInstance> instances,
                                    const std::vector<std::vector<bool>>& touching) {
  std::vector<Sorted> sorted;
  std::vector<std::vector<Vec3>> normals;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    sorted.push_back(sort_triangles(instances[i].triangles, touching[i]));
    normals.push_back(normals_of(instances[i]));
  }
  std::vector<GlbMesh> meshes;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    GlbMesh mesh{instances[i].name, instances[i].positions, normals[i], {}};
    if (!sorted[i].free.empty()) mesh.primitives.push_back({sorted[i].free, skin_material(i)});
    if (!sorted[i].touching.empty()) {
      mesh.primitives.push_back({sorted[i].touching, kContactMaterial});
    }
    meshes.push_back(std::move(mesh));
  }
  return make_glb(meshes, materials());
}

}  // namespace pelt::tools::scene
