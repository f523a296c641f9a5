#pragma once

#include <pelt/result.hpp>

#include <cstdint>
#include <string>

namespace pelt::asset {

/// How much memory a file may ask for. A few bytes can name the same mesh or the same keys over and
/// over (instances, shared accessors) or stand for zeros without number, so what is read is
/// counted, all of it, and stopped at `kExpansion` times what the file has. Real characters stay
/// under 20.
class Budget {
 public:
  static constexpr std::uint64_t kExpansion = 256;
  static constexpr std::uint64_t kStart = 16 << 20;  ///< for small files
  /// Vertices and triangles take 12 bytes at least, so below this their numbers fit 32 bits. Where
  /// addresses have 32 bits, 2 GB are there for everything: what is read takes up to twice as much
  /// on the way, and the model that is built of it as much again.
  static constexpr std::uint64_t kMost = std::uint64_t{sizeof(void*) == 8 ? 48 * 1024 : 256} << 20;

  /// Of the values in a JSON text, each of which may become a node of half a kilobyte.
  static constexpr std::uint64_t kMostValues =
      sizeof(void*) == 8 ? std::uint64_t{1} << 48 : 2'000'000;

  /// The file has `bytes` more than was known.
  void grant(std::uint64_t bytes);

  /// Counts `count` elements of `size` bytes, or refuses. `size` is small; `count` may be anything.
  Result<void> take(std::uint64_t count, std::uint64_t size, const std::string& what);

 private:
  std::uint64_t left_ = kStart;
  std::uint64_t granted_ = kStart;
};

}  // namespace pelt::asset
