#include "query/sort_contacts.hpp"

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
constexpr std::size_t kFewContacts = 48;

constexpr int kDigitBits = 8;

using Counts = std::array<std::uint32_t, std::size_t{1} << kDigitBits>;

const Contact& contact_of(const Contact& item) { return item; }
const Contact& contact_of(const MovingContact& item) { return item.contact; }

/// One stable pass by the digit of `number` that starts at bit `shift`.
template <typename Item>
void sort_by_digit(std::span<const Item> from, std::span<Item> to, std::uint32_t Contact::*number,
                   int shift) {
  const auto digit = [&](const Item& item) {
    return contact_of(item).*number >> shift & (Counts().size() - 1);
  };
  Counts position = {};
  for (const Item& item : from) ++position[digit(item)];
  std::uint32_t begin = 0;
  for (std::uint32_t& p : position) {
    const std::uint32_t count = p;
    p = begin;
    begin += count;
  }
  for (const Item& item : from) to[position[digit(item)]++] = item;
}

/// Sorts by the digits of `triangle_b`, then of `triangle_a`, from the least significant one.
template <typename Item>
void sort_items(Stack<Item>& items, Stack<Item>& buffer) {
  if (items.size() < kFewContacts) {
    std::sort(items.begin(), items.end(),
              [](const Item& x, const Item& y) { return contact_of(x) < contact_of(y); });
    return;
  }
  Contact all;  // the bits in use
  for (const Item& item : items) {
    all.triangle_a |= contact_of(item).triangle_a;
    all.triangle_b |= contact_of(item).triangle_b;
  }
  buffer.reserve(items.size());
  std::span<Item> from(items.begin(), items.size()), to(buffer.begin(), items.size());
  for (auto number : {&Contact::triangle_b, &Contact::triangle_a})
    for (int shift = 0; shift < static_cast<int>(std::bit_width(all.*number));
         shift += kDigitBits) {
      sort_by_digit<Item>(from, to, number, shift);
      std::swap(from, to);
    }
  if (from.data() != items.begin()) std::copy(from.begin(), from.end(), items.begin());
}

}  // namespace

void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer) {
  sort_items(contacts, buffer);
}

void sort_contacts(Stack<MovingContact>& contacts, Stack<MovingContact>& buffer) {
  sort_items(contacts, buffer);
}

void append_sorted(Scratch& scratch, std::vector<Contact>& contacts) {
  sort_contacts(scratch.found, scratch.sorting);
  contacts.insert(contacts.end(), scratch.found.begin(), scratch.found.end());
}

void append_sorted(Scratch& scratch, std::vector<MovingContact>& contacts) {
  sort_contacts(scratch.moving, scratch.sorting_moving);
  contacts.insert(contacts.end(), scratch.moving.begin(), scratch.moving.end());
}

namespace {

/// Smaller sets are sorted by comparison, because a radix sort has to clear its counters.
constexpr std::size_t kFewNumbers = 96;

/// One stable pass by the digit that starts at bit `shift`.
void sort_by_digit(std::span<const std::uint32_t> from, std::span<std::uint32_t> to, int shift) {
  Counts position = {};
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
