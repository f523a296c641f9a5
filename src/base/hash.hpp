#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::detail {

/// FNV-1a, 64 bits: the hash that `pelt check` prints over all contacts, and over input files.
class Fnv1a64 {
 public:
  void add_byte(std::uint8_t byte) { state_ = (state_ ^ byte) * 0x100000001b3u; }

  void add_bytes(std::span<const std::byte> bytes) {
    for (std::byte b : bytes) add_byte(static_cast<std::uint8_t>(b));
  }

  /// Adds the bytes in little-endian order on every machine.
  void add_u32(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(value >> shift));
  }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace pelt::detail
