#pragma once

/// Collects the contacts of a search, up to a limit.

#include <pelt/collide.hpp>

#include "base/instruction_set.hpp"
#include "query/stack.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// `AnyContact`: Contact or MovingContact.
template <typename AnyContact>
class LimitedSink {
 public:
  LimitedSink(Stack<AnyContact>& contacts, std::uint32_t max_contacts)
      : contacts_(contacts), max_contacts_(max_contacts) {}

  Stack<AnyContact>& contacts() const { return contacts_; }

  void push(const AnyContact& contact) const { contacts_.push(contact); }

  bool is_full() const { return contacts_.size() >= max_contacts_; }

  /// Whether so few contacts are missing that visiting likely pairs first, and testing candidates
  /// at once instead of collecting eight, saves work.
  bool is_impatient() const { return max_contacts_ - contacts_.size() < 8; }

  /// Removes contacts beyond the limit. Returns whether some are missing or may be: `is_unfinished`
  /// says whether work was left when the limit was reached.
  bool cut(bool is_unfinished) const {
    if (!is_full()) return false;
    const bool is_short = is_unfinished || contacts_.size() > max_contacts_;
    contacts_.shrink(max_contacts_);
    return is_short;
  }

 private:
  Stack<AnyContact>& contacts_;
  std::uint32_t max_contacts_;
};

using ContactSink = LimitedSink<Contact>;

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
