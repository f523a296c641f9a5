#include "motion/find_at_start.hpp"

#include "collide/collide_trees.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {

QueryStats find_at_start(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::optional<MovingContact>& first) {
  const QueryStats work = collide_trees(a, b, scratch, std::numeric_limits<std::uint32_t>::max());
  const auto& found = scratch.found;
  first.reset();
  if (!found.empty()) first = {*std::min_element(found.begin(), found.end()), 0, true, {}, {}};
  return work;
}

}  // namespace pelt::detail
