#include "base/hash.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace pelt::detail {
namespace {

std::vector<std::byte> some_bytes(std::size_t size) {
  test::Random random(size);
  std::vector<std::byte> bytes(size);
  for (std::byte& b : bytes) b = static_cast<std::byte>(random.bits());
  return bytes;
}

TEST(Checksum, StaysWhatFilesHave) {
  std::vector<std::byte> bytes(100);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i);
  EXPECT_EQ(Checksum::of({}), 0xab45aedc38e8b6fau);
  EXPECT_EQ(Checksum::of(bytes), 0x266d4ff67831d7a2u);
}

TEST(Checksum, KnowsHowManyZerosThereAre) {
  std::set<std::uint64_t> sums;
  for (std::size_t size = 0; size < 200; ++size)
    sums.insert(Checksum::of(std::vector<std::byte>(size)));
  EXPECT_EQ(sums.size(), 200u);
}

TEST(Checksum, FindsEveryFlippedBit) {
  const std::vector<std::byte> bytes = some_bytes(300);
  const std::uint64_t sum = Checksum::of(bytes);
  std::set<std::uint64_t> sums = {sum};
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::vector<std::byte> damaged = bytes;
    damaged[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
    sums.insert(Checksum::of(damaged));
  }
  EXPECT_EQ(sums.size(), 8 * bytes.size() + 1);
}

/// Multiplication does not spread the top bit of a word, so another flipped bit might cancel it.
TEST(Checksum, FindsTwoFlippedBits) {
  const std::vector<std::byte> bytes = some_bytes(96);
  const std::uint64_t sum = Checksum::of(bytes);
  for (std::size_t one = 0; one < 8 * bytes.size(); ++one)
    for (std::size_t two = 0; two < one; ++two) {
      std::vector<std::byte> damaged = bytes;
      damaged[one / 8] ^= static_cast<std::byte>(1 << one % 8);
      damaged[two / 8] ^= static_cast<std::byte>(1 << two % 8);
      ASSERT_NE(Checksum::of(damaged), sum) << one << " and " << two;
    }
}

TEST(Checksum, FindsExchangedWords) {
  const std::vector<std::byte> bytes = some_bytes(256);
  const std::uint64_t sum = Checksum::of(bytes);
  for (std::ptrdiff_t one = 0; one < 256; one += 4)
    for (std::ptrdiff_t two = 0; two < one; two += 4) {
      std::vector<std::byte> damaged = bytes;
      std::swap_ranges(damaged.begin() + one, damaged.begin() + one + 4, damaged.begin() + two);
      ASSERT_NE(Checksum::of(damaged), sum) << one << " and " << two;
    }
}

}  // namespace
}  // namespace pelt::detail
