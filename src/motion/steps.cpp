#include "motion/steps.hpp"

#include "base/require.hpp"
#include "pose/pose.hpp"

namespace pelt::detail {

void require_step(const Motion& motion) {
  require(&motion.from.model().detail() == &motion.to.model().detail(),
          "Motion: the poses of a motion are of different models");
}

void require_steps(const Motion& a, const Motion& b) {
  require_step(a);
  require_step(b);
  const bool is_shared =
      &a.from == &b.from || &a.from == &b.to || &a.to == &b.from || &a.to == &b.to;
  require(!is_shared, "Motion: `a` and `b` have a pose in common");
}

Steps::Steps(const Motion& a, const Motion& b)
    : a_from_(a.from.detail().posed_tree()),
      a_to_(a.to.detail().posed_tree()),
      b_from_(b.from.detail().posed_tree()),
      b_to_(b.to.detail().posed_tree()) {}

}  // namespace pelt::detail
