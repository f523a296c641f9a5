#pragma once

/// Layout of a prepared model in a file: a header, then the arrays of the model with their
/// in-memory layout, each starting at a multiple of 16 bytes, with gaps of zeros.
/// docs/prepared-format.md has the table of fields. Increase the version when a field or the
/// meaning of an array changes. Magic, version and byte order mark keep their offsets in all
/// versions.
///
/// Numbers are in the byte order of the machine that wrote them, which is little-endian on all
/// machines that run Pelt today. A file in the other order is rejected and must be prepared again;
/// this is simpler than byte swapping code that no available machine could test.

#include "base/hash.hpp"
#include "model/model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace pelt::detail {

/// Not valid text in any encoding, and damaged by any conversion of text, like the PNG signature.
inline constexpr std::array<unsigned char, 8> kPreparedMagic = {0x8B, 'P',  'E',  'L',
                                                                'T',  '\r', '\n', 0x1A};
inline constexpr std::uint32_t kPreparedVersion = 4;
inline constexpr std::uint32_t kByteOrderMark = 0x01020304, kForeignMark = 0x04030201;
inline constexpr std::size_t kPreparedArrays = 26;

struct PreparedHeader {
  std::array<unsigned char, 8> magic = kPreparedMagic;
  std::uint32_t version = kPreparedVersion;
  std::uint32_t byte_order = kByteOrderMark;
  std::uint64_t file_size = 0;  ///< bytes, including this header
  std::uint64_t checksum = 0;   ///< of all bytes after it

  std::uint32_t joint_count = 0;
  float rest_extent = 0;
  std::uint32_t dual_influences = 0;
  BuildReport report;
  std::array<std::uint32_t, kPreparedArrays> counts = {};  ///< elements of the arrays, in order
};

static_assert(sizeof(PreparedHeader) == 160 && std::is_trivially_copyable_v<PreparedHeader>);

// The element types have no padding bytes.
static_assert(sizeof(Cluster) == 12 && std::has_unique_object_representations_v<Cluster>);
static_assert(sizeof(Node) == 16 && std::has_unique_object_representations_v<Node>);
static_assert(sizeof(NodeBound) == 20 && sizeof(JointBox) == 32 && sizeof(RestShape) == 96 &&
              sizeof(JointFit) == 48 && sizeof(DisplacementBox) == 36);
static_assert(sizeof(DualBound) == 16 && sizeof(JointPair) == 56 && sizeof(JointLink) == 36);
static_assert(sizeof(PoolTarget) == 12 && sizeof(PlacedDisplacement) == 16);

/// Offset of the array that follows an array ending at `end`.
inline std::uint64_t next_array(std::uint64_t end) { return (end + 15) / 16 * 16; }

/// Size in bytes of a file with these numbers of elements.
inline std::uint64_t file_size_of(const std::array<std::uint32_t, kPreparedArrays>& counts) {
  std::uint64_t end = sizeof(PreparedHeader);
  std::size_t next = 0;
  const Model model;  // for the types of its arrays
  each_array(model, [&]<typename T>(const std::vector<T>&) {
    end = next_array(end) + counts[next++] * std::uint64_t{sizeof(T)};
  });
  return end;
}

/// Precondition: the file is not shorter than its header.
inline std::uint64_t checksum_of(std::span<const std::byte> file) {
  return Checksum::of(file.subspan(offsetof(PreparedHeader, joint_count)));
}

}  // namespace pelt::detail
