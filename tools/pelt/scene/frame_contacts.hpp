#pragma once

/// The contacts of one frame of a scene.

#include <pelt/collide.hpp>

#include "base/hash.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::scene {

/// Contacts, pair after pair of colliders.
struct FrameContacts {
  /// Colliders a < b, or one collider a = b, and their contacts: [begin, end) of `contacts`, not
  /// empty.
  struct Pair {
    std::uint32_t a = 0, b = 0;
    std::size_t begin = 0, end = 0;
  };

  std::vector<Pair> pairs;        ///< pairs in contact, ascending
  std::vector<Contact> contacts;  ///< triangle numbers of the two instances' models

  std::span<const Contact> of(const Pair& pair) const {
    return std::span(contacts).subspan(pair.begin, pair.end - pair.begin);
  }

  void clear() {
    pairs.clear();
    contacts.clear();
  }

  /// Appends a contact. Pairs of colliders ascend.
  void add(std::uint32_t a, std::uint32_t b, const Contact& contact) {
    const std::size_t end = contacts.size();
    if (pairs.empty() || pairs.back().a != a || pairs.back().b != b)
      pairs.push_back({a, b, end, end});
    pairs.back().end = end + 1;
    contacts.push_back(contact);
  }

  /// Calls `keep` for each pair, with its contacts. `keep` moves the contacts that stay to the
  /// front and returns their number. Removes all others, and pairs without contacts.
  template <typename Keep>
  void keep(const Keep& keep) {
    std::size_t end = 0;
    for (Pair& pair : pairs) {
      const std::span<Contact> own = std::span(contacts).subspan(pair.begin, pair.end - pair.begin);
      const std::size_t count = keep(pair, own);
      std::copy_n(own.begin(), count, contacts.begin() + static_cast<std::ptrdiff_t>(end));
      pair.begin = end;
      pair.end = end += count;
    }
    contacts.resize(end);
    std::erase_if(pairs, [](const Pair& pair) { return pair.begin == pair.end; });
  }
};

/// FNV-1a 64 over little-endian u32 frame, a, b, triangle_a, triangle_b of every contact, in that
/// order: equal for equal answers, whatever the method, machine or compiler.
class ContactHash {
 public:
  void add(std::uint32_t frame, const FrameContacts& found) {
    for (const FrameContacts::Pair& pair : found.pairs) {
      for (const Contact& contact : found.of(pair)) {
        for (const std::uint32_t value :
             {frame, pair.a, pair.b, contact.triangle_a, contact.triangle_b}) {
          hash_.add_u32(value);
        }
      }
    }
  }

  std::uint64_t value() const { return hash_.value(); }

 private:
  detail::Fnv1a64 hash_;
};

}  // namespace pelt::tools::scene
