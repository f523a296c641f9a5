#include "query/sort_contacts.hpp"

#include "query/scratch.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pelt::detail {
namespace {

TEST(SortNumbers, AsTheStandardDoes) {
  test::Random random(580);
  Stack<std::uint32_t> numbers, buffer;
  for (const std::size_t size : {0u, 1u, 2u, 95u, 96u, 97u, 1000u, 30000u})
    for (const int bits : {1, 8, 9, 16, 17, 32}) {
      numbers.clear();
      for (std::size_t i = 0; i < size; ++i)
        numbers.push(static_cast<std::uint32_t>(random.bits() >> (64 - bits)));
      std::vector<std::uint32_t> expected(numbers.begin(), numbers.end());
      std::sort(expected.begin(), expected.end());
      sort_numbers(numbers, buffer);
      EXPECT_TRUE(std::equal(expected.begin(), expected.end(), numbers.begin(), numbers.end()))
          << size << " of " << bits << " bits";
    }
}

}  // namespace
}  // namespace pelt::detail
