/// The fuzz target of glTF files: bytes -> load_gltf, then typical uses of a character.

#include "fuzz/goal.hpp"
#include "support/use_asset.hpp"

namespace pelt::test {
namespace {

Goal asset_used("load_gltf: a character that can be posed"), gltf_refused("load_gltf: an error");

void use_gltf(std::span<const std::byte> file) {
  const Result<asset::Asset> asset = asset::load_gltf(file, {});
  gltf_refused.reach(!asset);
  if (asset) asset_used.reach(use_asset(*asset));
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::use_gltf(std::as_bytes(std::span(data, size)));
  return 0;
}
