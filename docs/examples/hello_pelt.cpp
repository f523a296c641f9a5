#include <pelt/asset.hpp>
#include <pelt/pelt.hpp>

#include <cstdio>
#include <string>
#include <vector>

int fail(const std::string& message) {
  std::fprintf(stderr, "hello_pelt: %s\n", message.c_str());
  return 1;
}

int main(int argc, char** argv) {
  if (argc != 4) return fail("usage: hello_pelt CHARACTER.glb CLIP_A CLIP_B");
  const auto asset = pelt::asset::load_gltf(argv[1]);
  if (!asset) return fail(asset.error().message);
  const auto* clip_a = asset->find_clip(argv[2]);
  if (!clip_a) return fail(std::string(argv[1]) + " has no clip named " + argv[2]);
  const auto* clip_b = asset->find_clip(argv[3]);
  if (!clip_b) return fail(std::string(argv[1]) + " has no clip named " + argv[3]);
  const auto model = pelt::build_model(asset->mesh());
  if (!model) return fail(model.error().message);

  pelt::Pose a(*model), b(*model);
  pelt::Matrix4 place_a, place_b;
  place_b.m[12] = 0.5f;  // half a metre along +x: on a's own left, as glTF characters face +z
  std::vector<pelt::Matrix4> palette(model->joint_count());
  pelt::asset::SampleScratch sampling;
  pelt::Scratch scratch;
  std::vector<pelt::Contact> contacts;
  for (int frame = 0; frame < 120; ++frame) {
    const float seconds = static_cast<float>(frame) / 30;
    pelt::asset::sample_palette(*asset, clip_a, seconds, place_a, sampling, palette);
    if (const auto set = a.set_palette(palette); !set) return fail(set.error().message);
    pelt::asset::sample_palette(*asset, clip_b, seconds, place_b, sampling, palette);
    if (const auto set = b.set_palette(palette); !set) return fail(set.error().message);
    contacts.clear();
    pelt::collide(a, b, scratch, contacts);
    std::printf("frame %3d: %zu contacts\n", frame, contacts.size());
  }
}
