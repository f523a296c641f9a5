#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace pelt::detail {

/// A checksum against accidents, some ten times faster than hashing byte by byte: 64-bit words, in
/// the machine's order, go into four lanes in turn, so that four multiplications run side by side.
/// A step (after xxHash) loses nothing of the lane's state and nothing of the word, so damage
/// within one word is found for certain. It multiplies before and after the rotation, lest a
/// flipped bit stay alone in the state and be undone by another in a later word. No protection from
/// forgers.
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

  /// Takes the first block; a shorter one counts as followed by zeros.
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
