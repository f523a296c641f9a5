#include "collide/find_at_start.hpp"

#include "collide/lowest_contact.hpp"

namespace pelt::detail {

QueryStats find_at_start(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::optional<MovingContact>& first) {
  std::optional<Contact> lowest;
  const QueryStats work = lowest_contact(a, b, scratch, lowest);
  first.reset();
  if (lowest) first = {*lowest, 0, true, {}, {}};
  return work;
}

}  // namespace pelt::detail
