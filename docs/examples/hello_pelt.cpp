#include <pelt/asset.hpp>
#include <pelt/pelt.hpp>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 4) return std::puts("usage: hello_pelt CHARACTER.glb CLIP_A CLIP_B"), 2;
  const auto asset = pelt::asset::load_gltf(argv[1]);
  if (!asset) return std::puts(asset.error().message.c_str()), 1;
  const auto model = pelt::build_model(asset->mesh());
  if (!model) return std::puts(model.error().message.c_str()), 1;

  pelt::Pose a(*model), b(*model);
  pelt::Matrix4 place_a, place_b;
  place_b.m[12] = 0.5f;  // b stands half a metre to the left of a
  std::vector<pelt::Matrix4> palette(model->joint_count());
  pelt::asset::SampleScratch sampling;
  pelt::Scratch scratch;
  std::vector<pelt::Contact> contacts;
  for (int frame = 0; frame < 120; ++frame) {
    const float t = static_cast<float>(frame) / 30;
    sample_palette(*asset, asset->find_clip(argv[2]), t, place_a, sampling, palette);
    if (!a.set_palette(palette)) return 1;
    sample_palette(*asset, asset->find_clip(argv[3]), t, place_b, sampling, palette);
    if (!b.set_palette(palette)) return 1;
    contacts.clear();
    collide(a, b, scratch, contacts);
    std::printf("frame %3d: %zu contacts\n", frame, contacts.size());
  }
}
