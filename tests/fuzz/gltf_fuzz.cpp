/// The fuzz target of glTF files: bytes -> load_gltf, then typical uses of a character.

#include "support/use_asset.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = std::as_bytes(std::span(data, size));
  const pelt::Result<pelt::asset::Asset> asset = pelt::asset::load_gltf(file, {});
  if (asset) pelt::test::use_asset(*asset);
  return 0;
}
