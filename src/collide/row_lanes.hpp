#pragma once

#include "base/instruction_set.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A list of pairs of a row and a lane, both below 16, written without branches. The number of
/// lanes that a test leaves of a row is random, so a branch would often be mispredicted, which
/// costs more than the test.
class RowLanes {
 public:
  /// Adds the row with each lane whose bit is set.
  void add(unsigned row, unsigned lanes) {
    append(row << 4, lanes & 0xFF);
    append(row << 4 | 8, lanes >> 8);
  }

  std::uint32_t size() const { return size_; }
  unsigned row(std::uint32_t i) const { return pairs_[i] >> 4; }
  unsigned lane(std::uint32_t i) const { return pairs_[i] & 15; }

 private:
  /// For each byte, the indices of its set bits, lowest first, one byte each.
  static constexpr std::array<std::uint64_t, 256> kSetBits = [] {
    std::array<std::uint64_t, 256> numbers{};
    for (unsigned byte = 0; byte < 256; ++byte)
      for (unsigned bit = 0, place = 0; bit < 8; ++bit)
        if (byte >> bit & 1) numbers[byte] |= std::uint64_t{bit} << 8 * place++;
    return numbers;
  }();

  /// Always writes eight pairs; those beyond the set bits are overwritten by the next.
  void append(std::uint64_t pair, unsigned byte) {
    const std::uint64_t eight = kSetBits[byte] + pair * 0x0101010101010101;
    std::memcpy(pairs_ + size_, &eight, sizeof eight);
    size_ += static_cast<std::uint32_t>(std::popcount(byte));
  }

  std::uint32_t size_ = 0;
  std::uint8_t pairs_[16 * 16 + 8];
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
