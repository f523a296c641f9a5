#include "asset/meshopt.hpp"

#include "asset/little_endian.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::asset {
namespace {

/// Checks the preconditions of the decoder, which it asserts.
const char* broken_rule(const GltfMeshopt& meshopt) {
  const bool attributes = meshopt.mode == MeshoptMode::attributes;
  const std::uint64_t stride = meshopt.stride;
  if (attributes && (stride == 0 || stride > 256 || stride % 4 != 0)) {
    return "byteStride of ATTRIBUTES must be a multiple of 4, 4 to 256";
  }
  if (!attributes && stride != 2 && stride != 4) return "byteStride of indices must be 2 or 4";
  if (meshopt.mode == MeshoptMode::triangles && meshopt.count % 3 != 0) {
    return "count of TRIANGLES must be a multiple of 3";
  }
  if (!attributes && meshopt.filter != MeshoptFilter::none) return "indices have no filter";
  if (meshopt.filter == MeshoptFilter::octahedral && stride != 4 && stride != 8) {
    return "byteStride of filter OCTAHEDRAL must be 4 or 8";
  }
  if (meshopt.filter == MeshoptFilter::quaternion && stride != 8) {
    return "byteStride of filter QUATERNION must be 8";
  }
  return nullptr;
}

/// Upper bound of the number of elements in compressed bytes: an attribute byte takes at least 1/64
/// of a byte (a group of 16 equal ones takes 2 bits), three indices of TRIANGLES one byte, an index
/// of INDICES one byte.
std::uint64_t most_elements(const GltfMeshopt& meshopt) {
  if (meshopt.mode == MeshoptMode::attributes) return meshopt.length * 64 / meshopt.stride;
  return meshopt.mode == MeshoptMode::triangles ? meshopt.length * 3 : meshopt.length;
}

std::int16_t to_normalised(double value) {
  return static_cast<std::int16_t>(std::clamp(value, -1.0, 1.0) * 32767 + (value < 0 ? -0.5 : 0.5));
}

/// Decodes one rotation: the three smaller components in units of `scale` * sqrt 2; the fourth
/// number has the scale and the index of the omitted component.
void decode_quaternion(std::int16_t (&q)[4]) {
  const int left_out = q[3] & 3;
  const double unit = std::sqrt(0.5) / (q[3] | 3);
  const double x = q[0] * unit, y = q[1] * unit, z = q[2] * unit;
  const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y - z * z));
  q[(left_out + 1) & 3] = to_normalised(x);
  q[(left_out + 2) & 3] = to_normalised(y);
  q[(left_out + 3) & 3] = to_normalised(z);
  q[left_out] = to_normalised(w);
}

}  // namespace

// Implemented here, because decoders use the vector instructions of the machine, which round
// differently.
void decode_quaternion_filter(std::span<std::byte> bytes) {
  std::int16_t q[4];
  for (std::size_t i = 0; i + sizeof(q) <= bytes.size(); i += sizeof(q)) {
    std::memcpy(q, &bytes[i], sizeof(q));
    decode_quaternion(q);
    std::memcpy(&bytes[i], q, sizeof(q));
  }
}

Result<std::vector<std::byte>> decode_meshopt(const GltfMeshopt& meshopt,
                                              std::span<const std::byte> compressed, Budget& budget,
                                              const std::string& what) {
  if (const char* rule = broken_rule(meshopt)) return text::malformed(what + ": " + rule);
  if (meshopt.count > most_elements(meshopt)) {
    return text::malformed(what + ": " + std::to_string(compressed.size()) +
                           " compressed bytes cannot hold " + std::to_string(meshopt.count) +
                           " elements");
  }
  const Result<void> taken = budget.take(meshopt.count, meshopt.stride, what);
  if (!taken) return taken.error();
  std::vector<std::byte> bytes(meshopt.count * meshopt.stride);
  if (bytes.empty()) return bytes;
  if (const Result<void> decompressed = decompress(meshopt, compressed, bytes); !decompressed) {
    return text::prefixed(what, decompressed.error());
  }
  if (meshopt.filter == MeshoptFilter::quaternion) decode_quaternion_filter(bytes);
  return bytes;
}

}  // namespace pelt::asset
