#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pelt::test {

/// A small file that loads, in its two halves.
struct GltfSeed {
  std::string name;
  std::string json;
  std::vector<std::byte> binary;
};

/// Files that together have every feature of the format that the reader knows: where mutation
/// begins.
std::vector<GltfSeed> gltf_corpus();

}  // namespace pelt::test
