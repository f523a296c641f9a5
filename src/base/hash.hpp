#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// A checksum against accidents, about ten times faster than hashing byte by byte. 64-bit words in
/// the machine's byte order update four lanes in turn, so that four multiplications run in
/// parallel. A step (after xxHash) is a bijection in the lane and in the word, so damage within one
/// word is always detected. It multiplies before and after the rotation; otherwise a flipped bit
/// would stay isolated in the state, and another flipped bit in a later word could cancel it. Does
/// not protect against forgery.
class Checksum {
 public:
  static std::uint64_t of(std::span<const std::byte> bytes) {
    Checksum sum;
    for (; bytes.size() >= sizeof(Block); bytes = bytes.subspan(sizeof(Block))) sum.add(bytes);
    sum.add(bytes);
    return sum.value();
  }

 private:
  using Block = std::uint64_t[4];

  static std::uint64_t step(std::uint64_t state, std::uint64_t word) {
    return std::rotl(state + word * 0x9E3779B97F4A7C15u, 29) * 0xD1342543DE82EF95u;
  }

  /// Adds the first block of `bytes`, padded with zeros if it is shorter.
  void add(std::span<const std::byte> bytes) {
    const std::size_t size = bytes.size() < sizeof(Block) ? bytes.size() : sizeof(Block);
    Block words = {};
    if (size > 0) std::memcpy(words, bytes.data(), size);
    for (int i = 0; i < 4; ++i) lanes_[i] = step(lanes_[i], words[i]);
    size_ += size;
  }

  std::uint64_t value() const {
    std::uint64_t state = size_;
    for (const std::uint64_t lane : lanes_) state = step(state, lane);
    return state ^ state >> 32;
  }

  Block lanes_ = {1, 2, 3, 4};
  std::uint64_t size_ = 0;
};

}  // namespace pelt::detail
