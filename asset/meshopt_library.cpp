#include "asset/meshopt.hpp"
#include "text/message.hpp"

#include <meshoptimizer.h>

namespace pelt::asset {

namespace {

bool decode(const GltfMeshopt& meshopt, std::span<const std::byte> compressed,
            std::span<std::byte> out) {
  const auto* source = reinterpret_cast<const unsigned char*>(compressed.data());
  const std::size_t size = compressed.size();
  switch (meshopt.mode) {
    case MeshoptMode::attributes:
      return meshopt_decodeVertexBuffer(out.data(), meshopt.count, meshopt.stride, source, size) ==
             0;
    case MeshoptMode::triangles:
      return meshopt_decodeIndexBuffer(out.data(), meshopt.count, meshopt.stride, source, size) ==
             0;
    case MeshoptMode::indices:
      return meshopt_decodeIndexSequence(out.data(), meshopt.count, meshopt.stride, source, size) ==
             0;
  }
  return false;
}

void decode_filter(const GltfMeshopt& meshopt, std::span<std::byte> bytes) {
  switch (meshopt.filter) {
    case MeshoptFilter::none:
    case MeshoptFilter::quaternion:
      return;
    case MeshoptFilter::octahedral:
      return meshopt_decodeFilterOct(bytes.data(), meshopt.count, meshopt.stride);
    case MeshoptFilter::exponential:
      return meshopt_decodeFilterExp(bytes.data(), meshopt.count, meshopt.stride);
  }
}

}  // namespace

Result<void> decompress(const GltfMeshopt& meshopt, std::span<const std::byte> compressed,
                        std::span<std::byte> out) {
  if (!decode(meshopt, compressed, out)) return text::malformed("the compressed bytes are damaged");
  decode_filter(meshopt, out);
  return {};
}

}  // namespace pelt::asset
