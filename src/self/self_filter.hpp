#pragma once

/// A filter of self-collision with the data of its model, and the sink that leaves out contacts.

#include <pelt/motion.hpp>
#include <pelt/self_filter.hpp>

#include "model/model.hpp"
#include "query/contact_sink.hpp"
#include "query/stack.hpp"
#include "self/fans.hpp"
#include "self/pair_filters.hpp"
#include "self/pair_masks.hpp"

#include <cstdint>

namespace pelt::detail {

/// The data that copies of a pelt::SelfFilter share.
struct SelfFilter {
  SelfFilter(const SkinnedModel& m, const SelfFilterOptions& options)
      : model(m), fans(tree()), masks(tree(), fans), filters(model, fans, options) {}

  const Tree& tree() const { return model.detail().tree; }

  SkinnedModel model;
  Fans fans;
  PairMasks masks;
  PairFilters filters;
};

/// Returns false, and counts the contact, if the filter leaves it out. `ring` is working memory:
/// empty, or from the last call for this filter. Orders the triangles of a Contact; those of a
/// MovingContact are in order already, because its features depend on the order.
bool keeps(const SelfFilter& filter, Contact& contact, Stack<std::uint32_t>& ring,
           LeftOut& left_out);
bool keeps(const SelfFilter& filter, const MovingContact& contact, Stack<std::uint32_t>& ring,
           LeftOut& left_out);

inline namespace PELT_INSTRUCTION_SET {

/// Collects the contacts of a character with itself, up to a limit, without those that the filter
/// leaves out. `AnyContact`: Contact or MovingContact.
template <typename AnyContact>
class FilteredSink : public LimitedSink<AnyContact> {
 public:
  FilteredSink(const SelfFilter& filter, Stack<AnyContact>& contacts, Stack<std::uint32_t>& ring,
               std::uint32_t max_contacts, LeftOut& left_out)
      : LimitedSink<AnyContact>(contacts, max_contacts),
        filter_(filter),
        ring_(ring),
        left_out_(left_out) {
    ring.clear();
  }

  void push(AnyContact contact) {
    if (keeps(filter_, contact, ring_, left_out_)) LimitedSink<AnyContact>::push(contact);
  }

 private:
  const SelfFilter& filter_;
  Stack<std::uint32_t>& ring_;
  LeftOut& left_out_;
};

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail
