#pragma once

/// Collects the contacts of a pose with itself, up to a limit, without those that the filter leaves
/// out.

#include "query/contact_sink.hpp"
#include "self/self_filter.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// `AnyContact`: Contact or MovingContact.
template <typename AnyContact>
class SelfAnswerOf {
 public:
  SelfAnswerOf(const SelfFilter& filter, Stack<AnyContact>& contacts, Stack<std::uint32_t>& ring,
               std::uint32_t max_contacts, LeftOut& left_out)
      : filter_(filter), sink_(contacts, max_contacts), ring_(ring), left_out_(left_out) {
    ring.clear();
  }

  /// To append contacts; `settle` must be called before the next question to this object.
  Stack<AnyContact>& contacts() const { return sink_.contacts(); }

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }
  bool cut(bool is_unfinished) const { return sink_.cut(is_unfinished); }

  /// Asks the filter about the contacts that have been appended since the last call.
  void settle() {
    if (contacts().size() == settled_) return;
    leave_out(filter_, settled_, contacts(), ring_, left_out_);
    settled_ = contacts().size();
  }

 private:
  const SelfFilter& filter_;
  LimitedSink<AnyContact> sink_;
  Stack<std::uint32_t>& ring_;
  LeftOut& left_out_;
  std::size_t settled_ = 0;
};

using SelfAnswer = SelfAnswerOf<Contact>;

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
