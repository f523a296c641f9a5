#include "tools/pelt/scene/scene_glb.hpp"

#include "tools/pelt/output/glb_writer.hpp"

namespace pelt::tools::scene {
namespace {

constexpr std::array<std::array<float, 3>, 4> kSkinColours = {{
    {0.10F, 0.25F, 0.33F},  // slate blue
    {0.55F, 0.38F, 0.20F},  // sand
    {0.18F, 0.30F, 0.17F},  // moss
    {0.34F, 0.18F, 0.22F},  // plum
}};

/// One material per skin colour, then the material of triangles in contact.
std::vector<output::GlbMaterial> materials() {
  std::vector<output::GlbMaterial> all;
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

std::array<float, 3> skin_colour(std::size_t instance) {
  return kSkinColours[skin_material(instance)];
}

std::vector<std::byte> posed_glb(std::span<const PosedInstance> instances) {
  std::vector<output::GlbMesh> meshes;
  for (const PosedInstance& instance : instances) {
    output::GlbMesh mesh{instance.name, instance.positions, {}, {}};
    mesh.primitives.push_back({instance.triangles, skin_material(meshes.size())});
    meshes.push_back(std::move(mesh));
  }
  return output::make_glb(meshes, materials());
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
  std::vector<output::GlbMesh> meshes;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    output::GlbMesh mesh{instances[i].name, instances[i].positions, normals[i], {}};
    if (!sorted[i].free.empty()) mesh.primitives.push_back({sorted[i].free, skin_material(i)});
    if (!sorted[i].touching.empty()) {
      mesh.primitives.push_back({sorted[i].touching, kContactMaterial});
    }
    meshes.push_back(std::move(mesh));
  }
  return output::make_glb(meshes, materials());
}

}  // namespace pelt::tools::scene
