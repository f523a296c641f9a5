#include "base/hash.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace pelt::detail {
namespace {

std::uint64_t hash_of(std::string_view text) {
  Fnv1a64 hash;
  hash.add_bytes(std::as_bytes(std::span(text.data(), text.size())));
  return hash.value();
}

TEST(Fnv1a64, PublishedValues) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a64, NumbersAreLittleEndian) {
  Fnv1a64 by_number, by_bytes;
  by_number.add_u32(0x04030201);
  by_bytes.add_bytes(std::as_bytes(std::span("\1\2\3\4", 4)));
  EXPECT_EQ(by_number.value(), by_bytes.value());
}

TEST(Fnv1a64, NumbersOfAllSizesAreFourBytes) {
  Fnv1a64 by_number, by_bytes;
  for (std::uint32_t low : {0u, 1u, 0x7Fu, 0xFFu, 0x100u, 0x101u, 0xFF00u, 0xFFFFu, 0x10000u})
    for (std::uint32_t value : {low, low << 8, low << 16, ~low}) {
      by_number.add_u32(value);
      for (int byte = 0; byte < 4; ++byte)
        by_bytes.add_byte(static_cast<std::uint8_t>(value >> (8 * byte)));
      ASSERT_EQ(by_number.value(), by_bytes.value()) << value;
    }
}

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
