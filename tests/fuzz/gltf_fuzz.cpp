/// libFuzzer's way into the reader and what comes after it. Begin with the files that
/// gltf_seeds writes: gltf_fuzz -dict=gltf.dict seeds/

#include "support/use_asset.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = std::as_bytes(std::span(data, size));
  const pelt::Result<pelt::asset::Asset> asset = pelt::asset::load_gltf(file, {});
  if (asset) pelt::test::use_asset(*asset);
  return 0;
}
