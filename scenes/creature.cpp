#include "scenes/creature.hpp"

#include "scenes/creature/body.hpp"
#include "scenes/creature/motion.hpp"
#include "scenes/creature/skeleton.hpp"
#include "scenes/option_range.hpp"

#include <string>
#include <utility>

namespace pelt::scenes {

Result<asset::Asset> make_creature(const CreatureOptions& options) {
  for (const std::string& problem :
       {check_range("creature", "triangles", options.triangles, 1000, 1000000),
        check_range("creature", "joints", options.joints, kBaseJoints, kPlanJoints)}) {
    if (!problem.empty()) return Error{ErrorCode::invalid_argument, problem};
  }
  const BodyPlan plan = make_body_plan(draw_proportions(options.seed));
  const std::vector<std::uint32_t> stands_for = choose_joints(plan, options.joints);
  Body body = grow_body(plan, stands_for, options.triangles / 2 * 2, "creature");
  body.asset.clips.push_back(walk_clip(plan, stands_for, body.nodes));
  body.asset.clips.push_back(idle_clip(plan, stands_for, body.nodes));
  return std::move(body.asset);
}

}  // namespace pelt::scenes
