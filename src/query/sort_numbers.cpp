#include "query/sort_numbers.hpp"

#include "query/scratch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>

namespace pelt::detail {
namespace {

/// Smaller sets are sorted by comparison, because a radix sort has to clear its counters.
constexpr std::size_t kFewNumbers = 96;

constexpr int kDigitBits = 8;

/// One stable pass by the digit that starts at bit `shift`.
void sort_by_digit(std::span<const std::uint32_t> from, std::span<std::uint32_t> to, int shift) {
  std::array<std::uint32_t, std::size_t{1} << kDigitBits> position = {};
  const auto digit = [&](std::uint32_t number) { return number >> shift & (position.size() - 1); };
  for (const std::uint32_t number : from) ++position[digit(number)];
  std::uint32_t begin = 0;
  for (std::uint32_t& p : position) {
    const std::uint32_t count = p;
    p = begin;
    begin += count;
  }
  for (const std::uint32_t number : from) to[position[digit(number)]++] = number;
}

}  // namespace

void sort_numbers(Stack<std::uint32_t>& numbers, Stack<std::uint32_t>& buffer) {
  if (numbers.size() < kFewNumbers) {
    std::sort(numbers.begin(), numbers.end());
    return;
  }
  std::uint32_t used_bits = 0;
  for (const std::uint32_t number : numbers) used_bits |= number;
  buffer.reserve(numbers.size());
  std::span<std::uint32_t> from(numbers.begin(), numbers.size()), to(buffer.begin(), from.size());
  for (int shift = 0; shift < static_cast<int>(std::bit_width(used_bits)); shift += kDigitBits) {
    sort_by_digit(from, to, shift);
    std::swap(from, to);
  }
  if (from.data() != numbers.begin()) std::copy(from.begin(), from.end(), numbers.begin());
}

}  // namespace pelt::detail
