#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pelt::test {

/// A small valid file, as JSON and binary data.
struct GltfSeed {
  std::string name;
  std::string json;
  std::vector<std::byte> binary;
};

/// Files that together use every feature of the format that the reader supports: seeds for
/// mutation.
std::vector<GltfSeed> gltf_corpus();

}  // namespace pelt::test
