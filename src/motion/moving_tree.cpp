#include "motion/moving_tree.hpp"

#include "base/assert.hpp"
#include "pose/pose.hpp"

namespace pelt::detail {
namespace {

void require_step(const Motion& motion) {
  require(&motion.from.model().detail() == &motion.to.model().detail(),
          "Motion: the poses of a motion are of different models");
}

}  // namespace

Step step_of(const Motion& motion) {
  require_step(motion);
  return {motion.from.detail().posed_tree(), motion.to.detail().posed_tree()};
}

void require_steps(const Motion& a, const Motion& b) {
  require_step(a);
  require_step(b);
  const bool is_shared =
      &a.from == &b.from || &a.from == &b.to || &a.to == &b.from || &a.to == &b.to;
  require(!is_shared, "Motion: `a` and `b` have a pose in common");
}

}  // namespace pelt::detail
