#include "lane_operations.hpp"

#include "support/instruction_sets.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using test::ShortResults;

struct Compiled {
  InstructionSet set;
  test::ShortOperations* short_operations;
};

constexpr Compiled kCompiled[] = {
    {InstructionSet::scalar, test::scalar::short_operations},
#ifdef PELT_HAS_SIMD128
    {InstructionSet::simd128, test::simd128::short_operations},
#endif
#ifdef PELT_HAS_AVX2
    {InstructionSet::avx2, test::avx2::short_operations},
#endif
};

std::int16_t interesting_short(test::Random& random) {
  constexpr std::int16_t kSpecial[] = {0, 1, -1, 32767, -32768, -32767, 255, 256};
  if (random.chance(0.5)) return kSpecial[random.index(std::size(kSpecial))];
  return static_cast<std::int16_t>(random.bits());
}

void expect_results(const ShortResults& results, const std::int16_t* a, const std::int16_t* b,
                    const float* floats) {
  for (unsigned i = 0; i < 16; ++i) {
    EXPECT_EQ(results.first[i], a[i]);
    EXPECT_EQ(results.both[i], a[i] & b[i]);
    EXPECT_EQ(results.repeated[i], a[5]);
    EXPECT_EQ(results.truncated[i], static_cast<int>(floats[i])) << floats[i];
    EXPECT_EQ(results.greater >> i & 1, a[i] > b[i]);
    EXPECT_EQ(results.equal >> i & 1, a[i] == b[i]);
    EXPECT_EQ(results.either >> i & 1, a[i] >= b[i]);
  }
  EXPECT_LT(results.greater | results.equal | results.either, 1u << 16);
}

TEST(Short16, DoesInEachLaneWhatPlainIntegersDo) {
  int ran = 0;
  for (const Compiled& compiled : kCompiled) {
    if (!test::runs_here(compiled.set)) continue;
    SCOPED_TRACE(name_of(compiled.set));
    ++ran;
    test::Random random(41);
    std::int16_t a[17], b[17];
    float floats[17];
    for (int round = 0; round < 2000 && !testing::Test::HasFailure(); ++round) {
      std::generate(a, a + 17, [&] { return interesting_short(random); });
      std::generate(b, b + 17, [&] { return interesting_short(random); });
      for (int i = 0; i < 17; ++i) {
        if (random.chance(0.2)) b[i] = a[i];
        floats[i] = random.chance(0.5) ? interesting_short(random) : random.uniformf(-300, 300);
      }
      const int offset = round % 2;  // addresses that are not multiples of a row's size
      expect_results(compiled.short_operations(a + offset, b + offset, floats + offset), a + offset,
                     b + offset, floats + offset);
    }
  }
  EXPECT_EQ(ran, std::ssize(available_instruction_sets()));
}

}  // namespace
}  // namespace pelt
