#pragma once

#include "base/hash.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"

namespace pelt::tools::scene {

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
