#include <pelt/pelt.hpp>

#include <cstdio>

void print_contacts(const pelt::SkinnedMeshView& mesh, std::span<const pelt::Matrix4> palette_a,
                    std::span<const pelt::Matrix4> palette_b) {
  const auto model = pelt::build_model(mesh);  // once: your positions, triangles, joints, weights
  pelt::Pose a(*model), b(*model);             // one for each character in the scene
  pelt::Scratch scratch;                       // one for each thread
  std::vector<pelt::Contact> contacts;

  if (!a.set_palette(palette_a) || !b.set_palette(palette_b)) return;  // in every frame
  pelt::collide(a, b, scratch, contacts);
  for (const auto& [of_a, of_b] : contacts)
    std::printf("triangle %u of a touches triangle %u of b\n", of_a, of_b);
}
