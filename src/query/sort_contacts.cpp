#include "query/sort_contacts.hpp"

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

/// One stable pass by the digit of `number` that starts at bit `shift`.
void sort_by_digit(std::span<const Contact> from, std::span<Contact> to,
                   std::uint32_t Contact::*number, int shift) {
  const auto digit = [&](const Contact& contact) {
    return contact.*number >> shift & (Counts().size() - 1);
  };
  Counts position = {};
  for (const Contact& contact : from) ++position[digit(contact)];
  std::uint32_t begin = 0;
  for (std::uint32_t& p : position) {
    const std::uint32_t count = p;
    p = begin;
    begin += count;
  }
  for (const Contact& contact : from) to[position[digit(contact)]++] = contact;
}

}  // namespace

/// Sorts by the digits of `triangle_b`, then of `triangle_a`, from the least significant one.
void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer) {
  if (contacts.size() < kFewContacts) {
    std::sort(contacts.begin(), contacts.end());
    return;
  }
  Contact all;  // the bits in use
  for (const Contact& contact : contacts) {
    all.triangle_a |= contact.triangle_a;
    all.triangle_b |= contact.triangle_b;
  }
  buffer.reserve(contacts.size());
  std::span<Contact> from(contacts.begin(), contacts.size()), to(buffer.begin(), contacts.size());
  for (auto number : {&Contact::triangle_b, &Contact::triangle_a})
    for (int shift = 0; shift < static_cast<int>(std::bit_width(all.*number));
         shift += kDigitBits) {
      sort_by_digit(from, to, number, shift);
      std::swap(from, to);
    }
  if (from.data() != contacts.begin()) std::copy(from.begin(), from.end(), contacts.begin());
}

void append_sorted(Scratch& scratch, std::vector<Contact>& contacts) {
  sort_contacts(scratch.found, scratch.sorting);
  contacts.insert(contacts.end(), scratch.found.begin(), scratch.found.end());
}

}  // namespace pelt::detail
