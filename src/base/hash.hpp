#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::detail {

/// FNV-1a, 64 bits: the hash that `pelt check` prints over all contacts, and over input files.
class Fnv1a64 {
 public:
  void add_byte(std::uint8_t byte) { state_ = (state_ ^ byte) * kPrime; }

  void add_bytes(std::span<const std::byte> bytes) {
    for (std::byte b : bytes) add_byte(static_cast<std::uint8_t>(b));
  }

  /// Adds the bytes in little-endian order on every machine.
  void add_u32(std::uint32_t value) {
    if (value < 0x10000) return add_small(value);
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(value >> shift));
  }

  std::uint64_t value() const { return state_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001b3u;
  static constexpr std::uint64_t kPrime3 = kPrime * kPrime * kPrime;

  /// Adds the four bytes of a value below 2^16, most of which are zero. A zero byte only
  /// multiplies, and the time is that of the multiplications, which wait for one another.
  void add_small(std::uint32_t value) {
    if (value >= 0x100) add_byte(static_cast<std::uint8_t>(value));
    state_ =
        value >= 0x100 ? (state_ ^ (value >> 8)) * kPrime3 : (state_ ^ value) * kPrime3 * kPrime;
  }

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace pelt::detail
