/// posed_corners MODEL OUT CLIP:SECONDS...: writes the vertices of all triangles for each pose, as
/// Pelt poses them, nine float32 per triangle. CLIP is an index; -1 is the default pose.

#include <pelt/asset.hpp>
#include <pelt/pelt.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace {

using namespace pelt;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

std::vector<Vec3> corners(const asset::Asset& asset, const Pose& pose) {
  std::vector<Vec3> posed(asset.rest_positions.size()), corners;
  posed_vertices(pose, posed);
  for (const Triangle& triangle : asset.triangles) {
    for (const std::uint32_t vertex : triangle) corners.push_back(posed[vertex]);
  }
  return corners;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const Result<asset::Asset> asset = asset::load_gltf(std::filesystem::path(argv[1]));
  if (!asset) return fail(asset.error());
  const Result<SkinnedModel> model = build_model(asset->mesh());
  if (!model) return fail(model.error());
  Pose pose(*model);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(asset->joints.size());
  std::ofstream out(argv[2], std::ios::binary);
  for (int i = 3; i < argc; ++i) {
    const int clip = std::atoi(argv[i]);
    const float seconds = std::strtof(std::strchr(argv[i], ':') + 1, nullptr);
    const asset::Clip* chosen = clip < 0 ? nullptr : &asset->clips[static_cast<std::size_t>(clip)];
    asset::sample_palette(*asset, chosen, seconds, Matrix4{}, scratch, palette);
    std::vector<float> weights(asset->morph_targets.size());
    asset::sample_morph_weights(*asset, chosen, seconds, weights);
    const Result<void> set = pose.set_palette(palette), morphed = pose.set_morph_weights(weights);
    if (!set) return fail(set.error());
    if (!morphed) return fail(morphed.error());
    const std::vector<Vec3> points = corners(*asset, pose);
    out.write(reinterpret_cast<const char*>(points.data()),
              static_cast<std::streamsize>(points.size() * sizeof(Vec3)));
  }
  return 0;
}
