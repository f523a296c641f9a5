/// gltf_seeds FOLDER: writes the generated files, for comparison with another reader and as seeds
/// for fuzzing.

#include "support/gltf_builder.hpp"
#include "support/gltf_corpus.hpp"

#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const pelt::test::GltfSeed& seed : pelt::test::gltf_corpus()) {
    if (seed.binary.empty()) {
      std::ofstream(folder / (seed.name + ".gltf")) << seed.json;
      continue;
    }
    const std::vector<std::byte> file = pelt::test::make_glb(seed.json, seed.binary);
    std::ofstream glb(folder / (seed.name + ".glb"), std::ios::binary);
    glb.write(reinterpret_cast<const char*>(file.data()),
              static_cast<std::streamsize>(file.size()));
  }
  return 0;
}
