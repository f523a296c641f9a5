#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string_view>

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

}  // namespace
}  // namespace pelt::detail
