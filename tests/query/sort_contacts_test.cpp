#include "query/sort_contacts.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using detail::Stack;

/// Contacts of triangles below `limit`.
std::vector<Contact> random_contacts(test::Random& random, std::size_t count, std::uint32_t limit) {
  std::vector<Contact> contacts(count);
  for (Contact& contact : contacts) {
    contact.triangle_a = random.index(limit);
    contact.triangle_b = random.index(limit);
  }
  return contacts;
}

TEST(SortContacts, AsComparingWould) {
  test::Random random(31);
  Stack<Contact> contacts, buffer;
  for (const std::size_t count : {0, 1, 2, 47, 48, 49, 1000, 20000})
    for (const std::uint32_t limit : {1u, 2u, 256u, 257u, 70000u, 0x7FFFFFFFu}) {
      std::vector<Contact> expected = random_contacts(random, count, limit);
      contacts.clear();
      for (const Contact& contact : expected) contacts.push(contact);
      std::sort(expected.begin(), expected.end());
      sort_contacts(contacts, buffer);
      EXPECT_EQ(std::vector<Contact>(contacts.begin(), contacts.end()), expected)
          << count << " below " << limit;
    }
}

}  // namespace
}  // namespace pelt
