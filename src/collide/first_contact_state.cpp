#include "collide/first_contact_state.hpp"

namespace pelt::detail {

void FirstContactState::clear(const Tree& a, const Tree& b) {
  open.clear();
  at_start.reset();
  after_start = {};
  work = {};
  clear_needed(needed_a.from, a);
  clear_needed(needed_a.to, a);
  clear_needed(needed_b.from, b);
  clear_needed(needed_b.to, b);
}

float FirstContactState::latest() const { return at_start ? 0 : after_start.latest(); }

std::optional<MovingContact> FirstContactState::earliest() const {
  if (at_start) return MovingContact{*at_start, 0, true, {}, {}};
  return after_start.contact();
}

}  // namespace pelt::detail
