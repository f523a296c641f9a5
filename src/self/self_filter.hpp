#pragma once

#include <pelt/motion.hpp>
#include <pelt/self_filter.hpp>

#include "model/model.hpp"
#include "self/fans.hpp"
#include "self/pair_filters.hpp"
#include "self/pair_masks.hpp"

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

inline Contact& pair_of(Contact& contact) { return contact; }
inline Contact& pair_of(MovingContact& contact) { return contact.contact; }

/// Removes from the contacts those from number `first` on that the filter leaves out, and counts
/// them. Orders the triangles of each contact. `ring` is working memory: empty, or from the last
/// call for this filter.
/// `AnyContact`: Contact or MovingContact.
template <typename AnyContact>
void leave_out(const SelfFilter& filter, std::size_t first, Stack<AnyContact>& contacts,
               Stack<std::uint32_t>& ring, LeftOut& left_out);

}  // namespace pelt::detail
