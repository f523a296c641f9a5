/// Randomly damaged files must be refused, or load as something usable, without a crash and without
/// excessive memory. The sanitizers detect errors; the memory is counted here.

#include "support/allocation_count.hpp"
#include "support/gltf_builder.hpp"
#include "support/gltf_corpus.hpp"
#include "support/random.hpp"
#include "support/use_asset.hpp"

#include <pelt/asset.hpp>

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

using asset::Asset;

/// Number of mutated files that load, and of those that are refused.
struct Tally {
  int loaded = 0, refused = 0, used = 0;
};

void try_file(std::span<const std::byte> file, Tally& tally) {
  const Result<Asset> asset = asset::load_gltf(file, {});
  if (!asset) {
    EXPECT_FALSE(asset.error().message.empty());
    EXPECT_LT(asset.error().message.size(), 2000u);
    ++tally.refused;
    return;
  }
  ++tally.loaded;
  tally.used += use_asset(*asset);
}

/// The reader grants 16 MiB to any file, and a growing vector allocates more than it needs.
void expect_little_memory() { EXPECT_LE(largest_allocation(), std::size_t{64} << 20); }

void expect_both(const Tally& tally, int loaded, int used) {
  std::printf("%d loaded, %d of them could be used, %d refused\n", tally.loaded, tally.used,
              tally.refused);
  EXPECT_GT(tally.loaded, loaded);
  EXPECT_GT(tally.used, used);
  EXPECT_GT(tally.refused, 500);
}

TEST(Mutation, SeedsLoad) {
  for (const GltfSeed& seed : gltf_corpus()) {
    const Result<Asset> asset = asset::load_gltf(make_glb(seed.json, seed.binary), {});
    ASSERT_TRUE(asset) << seed.name << ": " << asset.error().message;
  }
}

TEST(Mutation, FlippedBits) {
  Random random(1);
  Tally tally;
  for (const GltfSeed& seed : gltf_corpus()) {
    const std::vector<std::byte> original = make_glb(seed.json, seed.binary);
    for (int round = 0; round < 2500; ++round) {
      std::vector<std::byte> file = original;
      const std::uint32_t flips = 1 + random.index(4);
      for (std::uint32_t i = 0; i < flips; ++i) {
        file[random.index(static_cast<std::uint32_t>(file.size()))] ^=
            static_cast<std::byte>(1 << random.index(8));
      }
      try_file(file, tally);
    }
  }
  expect_both(tally, 1000, 300);
  expect_little_memory();
}

TEST(Mutation, FlippedBitsOfTheBinaryHalf) {
  Random random(2);
  Tally tally;
  for (const GltfSeed& seed : gltf_corpus()) {
    if (seed.binary.empty()) continue;
    for (int round = 0; round < 1500; ++round) {
      std::vector<std::byte> binary = seed.binary;
      binary[random.index(static_cast<std::uint32_t>(binary.size()))] =
          static_cast<std::byte>(random.bits());
      try_file(make_glb(seed.json, binary), tally);
    }
  }
  expect_both(tally, 1000, 300);
  expect_little_memory();
}

TEST(Mutation, TruncationsAndInsertions) {
  Random random(3);
  Tally tally;
  for (const GltfSeed& seed : gltf_corpus()) {
    const std::vector<std::byte> original = make_glb(seed.json, seed.binary);
    for (int round = 0; round < 500; ++round) {
      std::vector<std::byte> file = original;
      const auto at =
          static_cast<std::ptrdiff_t>(random.index(static_cast<std::uint32_t>(file.size())));
      const auto length = static_cast<std::ptrdiff_t>(random.index(16));
      if (random.chance(0.5)) {
        file.resize(static_cast<std::size_t>(at));
      } else {
        file.insert(file.begin() + at, static_cast<std::size_t>(length), std::byte{'0'});
      }
      try_file(file, tally);
    }
  }
  EXPECT_GT(tally.refused, 2000);
  expect_little_memory();
}

/// Positions of the numbers in a JSON text.
std::vector<std::pair<std::size_t, std::size_t>> find_numbers(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') in_string = !in_string;
    if (in_string || !(text[i] == '-' || (text[i] >= '0' && text[i] <= '9'))) continue;
    const std::size_t end = text.find_first_not_of("-+.eE0123456789", i);
    numbers.emplace_back(i, end - i);
    i = end - 1;
  }
  return numbers;
}

TEST(Mutation, ReplacedNumbers) {
  static const char* const kNumbers[] = {"0",
                                         "1",
                                         "2",
                                         "3",
                                         "4",
                                         "5",
                                         "7",
                                         "8",
                                         "12",
                                         "16",
                                         "-1",
                                         "0.5",
                                         "255",
                                         "256",
                                         "5120",
                                         "5121",
                                         "5123",
                                         "5125",
                                         "5126",
                                         "65535",
                                         "65536",
                                         "2147483647",
                                         "2147483648",
                                         "4294967295",
                                         "4294967296",
                                         "1000000000",
                                         "1e9",
                                         "1e300",
                                         "-1e300",
                                         "1e-45",
                                         "null",
                                         "\"x\"",
                                         "[]",
                                         "{}",
                                         "true",
                                         "1e400",
                                         "6148914691236517205",
                                         "9223372036854775808",
                                         "18446744073709551615",
                                         "18446744073709551616"};
  Random random(4);
  Tally tally;
  for (const GltfSeed& seed : gltf_corpus()) {
    const std::vector<std::pair<std::size_t, std::size_t>> numbers = find_numbers(seed.json);
    for (int round = 0; round < 2500; ++round) {
      std::string text = seed.json;
      const auto& place = numbers[random.index(static_cast<std::uint32_t>(numbers.size()))];
      text.replace(place.first, place.second, kNumbers[random.index(std::size(kNumbers))]);
      try_file(make_glb(text, seed.binary), tally);
    }
  }
  expect_both(tally, 1000, 300);
  expect_little_memory();
}

TEST(Mutation, SwappedPiecesOfText) {
  Random random(5);
  Tally tally;
  for (const GltfSeed& seed : gltf_corpus()) {
    for (int round = 0; round < 1500; ++round) {
      std::string text = seed.json;
      const auto size = static_cast<std::uint32_t>(text.size());
      const std::size_t from = random.index(size), to = random.index(size);
      text.replace(to, random.index(12), seed.json.substr(from, random.index(24)));
      try_file(make_glb(text, seed.binary), tally);
    }
  }
  EXPECT_GT(tally.refused, 1000);
  expect_little_memory();
}

}  // namespace
}  // namespace pelt::test
