/// Damaged prepared models must be refused, or load as something that queries can use, without a
/// crash and without excessive memory. The sanitizers detect errors; the memory is counted here. A
/// separate program, because it replaces operator new.

#include "support/allocation_count.hpp"
#include "support/dual_shapes.hpp"
#include "support/prepared_file.hpp"
#include "support/random.hpp"
#include "support/skinned_shapes.hpp"
#include "support/use_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

/// A model of a few nodes, with both kinds of bounds and morph targets.
SkinnedModel small_model() {
  SkinnedModel model = *build_model(make_morphing_limb(20, 8, 3).view());
  EXPECT_FALSE(model.detail().bounds.joint_boxes.empty());
  EXPECT_FALSE(model.detail().bounds.fits.empty());
  EXPECT_GT(model.detail().tree.nodes.size(), 2u);
  return model;
}

/// Number of damaged files that were refused, loaded, and could then be posed.
struct Tally {
  int refused = 0, loaded = 0, used = 0;
};

void try_file(const Bytes& file, Tally& tally) {
  const Result<SkinnedModel> model = load_model(file);
  if (model) {
    ++tally.loaded;
    tally.used += use_model(*model);
    return;
  }
  EXPECT_FALSE(model.error().message.empty());
  EXPECT_LT(model.error().message.size(), 500u);
  ++tally.refused;
}

void print(const Tally& tally) {
  std::printf("%d refused, %d loaded, %d of them could be used\n", tally.refused, tally.loaded,
              tally.used);
}

TEST(PreparedMutation, EveryTruncationIsRefused) {
  const Bytes file = save_model(small_model());
  Tally tally;
  for (std::size_t size = 0; size < file.size(); ++size) {
    Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    try_file(cut, tally);
    mend(cut);
    try_file(cut, tally);
  }
  EXPECT_EQ(tally.loaded, 0);
  EXPECT_EQ(tally.refused, static_cast<int>(2 * file.size()));
}

TEST(PreparedMutation, EveryFlippedByteIsRefused) {
  const Bytes file = save_model(small_model());
  Tally tally;
  for (std::size_t at = 0; at < file.size(); ++at)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      Bytes damaged = file;
      damaged[at] ^= static_cast<std::byte>(flip);
      try_file(damaged, tally);
    }
  EXPECT_EQ(tally.loaded, 0);
}

TEST(PreparedMutation, EveryFlippedByteIsHarmlessWhereTheChecksumHasBeenMended) {
  const Bytes file = save_model(small_model());
  Tally tally;
  for (std::size_t at = 0; at < file.size(); ++at)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      Bytes forged = file;
      forged[at] ^= static_cast<std::byte>(flip);
      mend(forged);
      try_file(forged, tally);
    }
  print(tally);
  EXPECT_GT(tally.refused, static_cast<int>(file.size())) << "of three times that";
  EXPECT_GT(tally.used, static_cast<int>(file.size() / 4));
}

TEST(PreparedMutation, FlippedBytesOfDualBoundsAreHarmless) {
  const SkinnedModel model = *build_model(make_limb(20, 8, 3).view(), kDual);
  const Bytes file = save_model(model);
  ASSERT_FALSE(model.detail().bounds.joint_pairs.empty());
  const std::vector<std::size_t> places = array_places(model.detail());
  Tally tally;
  for (std::size_t at = places[places.size() - 3]; at < file.size(); ++at)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      Bytes forged = file;
      forged[at] ^= static_cast<std::byte>(flip);
      mend(forged);
      try_file(forged, tally);
    }
  print(tally);
  EXPECT_GT(tally.refused, 100);
  EXPECT_GT(tally.used, 100);
}

/// Extreme values of each field, at the positions of numbers.
template <typename T>
void replace_number(Bytes& file, Random& random, std::initializer_list<T> numbers) {
  const T number = numbers.begin()[random.index(static_cast<std::uint32_t>(numbers.size()))];
  const auto places = static_cast<std::uint32_t>(file.size() / sizeof(T));
  std::memcpy(&file[sizeof(T) * random.index(places)], &number, sizeof(T));
}

TEST(PreparedMutation, ForgedNumbersAreHarmless) {
  Random random(301);
  const Bytes file = save_model(small_model());
  Tally tally;
  for (int round = 0; round < 20000; ++round) {
    Bytes forged = file;
    for (std::uint32_t count = 1 + random.index(3); count > 0; --count) {
      if (random.chance(0.5))
        replace_number<float>(forged, random,
                              {0.0f, -1.0f, 1e-45f, 0x1p-60f, 0x1p28f, 0x1p60f, 0x1p61f, 3e38f,
                               HUGE_VALF, -HUGE_VALF, std::nanf("")});
      else if (random.chance(0.5))
        replace_number<std::uint32_t>(forged, random,
                                      {0, 1, 7, 0x7FFFFFFF, 0x80000000, UINT32_MAX});
      else
        replace_number<std::uint16_t>(forged, random, {0, 1, 2, 16, 255, 0x7FFF, UINT16_MAX});
    }
    mend(forged);
    try_file(forged, tally);
  }
  print(tally);
  EXPECT_GT(tally.refused, 5000);
  EXPECT_GT(tally.used, 500);
}

TEST(PreparedMutation, PiecesOfAnotherModelAreHarmless) {
  Random random(302);
  const Bytes one = save_model(small_model());
  const Bytes two = save_model(*build_model(make_morphing_limb(20, 8, 4).view()));
  Tally tally;
  for (int round = 0; round < 3000; ++round) {
    Bytes forged = one;
    const std::size_t from = random.index(static_cast<std::uint32_t>(two.size()));
    const std::size_t to = random.index(static_cast<std::uint32_t>(one.size()));
    const std::size_t length =
        std::min({std::size_t{random.index(200)}, two.size() - from, one.size() - to});
    std::copy_n(&two[from], length, &forged[to]);
    mend(forged);
    try_file(forged, tally);
  }
  print(tally);
  EXPECT_GT(tally.refused, 1000);
}

/// Must run after the other tests of this file.
TEST(PreparedMutation, NoneOfThemTookMuchMemory) {
  // The largest is a palette of the 65535 joints that a small file may declare.
  EXPECT_LE(largest_allocation(), std::size_t{65535} * sizeof(Matrix4));
}

}  // namespace
}  // namespace pelt::test
