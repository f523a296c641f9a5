#pragma once

#include <pelt/result.hpp>

#include <cstdint>
#include <string>

namespace pelt::asset {

/// Limits the memory that a file may need. A few bytes can refer to the same mesh or the same keys
/// many times (instances, shared accessors), or stand for any number of zeros. Everything that is
/// read is therefore counted, and rejected beyond `kExpansion` times the size of the file. Real
/// characters stay below 20.
class Budget {
 public:
  static constexpr std::uint64_t kExpansion = 256;
  static constexpr std::uint64_t kStart = 16 << 20;  ///< additional allowance, for small files
  /// Vertices and triangles have at least 12 bytes, so below this limit their numbers fit into 32
  /// bits. On 32-bit platforms, 2 GB must suffice for everything: reading needs up to twice the
  /// result, and building the model needs as much again.
  static constexpr std::uint64_t kMax = std::uint64_t{sizeof(void*) == 8 ? 48 * 1024 : 256} << 20;

  /// Limit of the values in a JSON text, each of which may become a node of half a kilobyte.
  static constexpr std::uint64_t kMaxValues =
      sizeof(void*) == 8 ? std::uint64_t{1} << 48 : 2'000'000;

  /// Increases the known size of the file by `bytes`.
  void grant(std::uint64_t bytes);

  /// Counts `count` elements of `size` bytes, or returns an error. `size` is small; `count` may be
  /// any number.
  Result<void> take(std::uint64_t count, std::uint64_t size, const std::string& what);

 private:
  std::uint64_t left_ = kStart;
  std::uint64_t granted_ = kStart;
};

}  // namespace pelt::asset
