#include "scenes/creature.hpp"

#include "scenes/creature/body.hpp"
#include "scenes/creature/expressions.hpp"
#include "scenes/creature/motion.hpp"

#include <string>
#include <utility>

namespace pelt::scenes {
namespace {

/// Returns all joints except the jaw, which is a morph target.
std::vector<std::uint32_t> joints_of(const BodyPlan& bust) {
  std::vector<std::uint32_t> stands_for;
  for (std::uint32_t j = 0; j < bust.joints.size(); ++j) stands_for.push_back(j);
  stands_for[find_joint(bust, "jaw")] = find_joint(bust, "head");
  return stands_for;
}

void add_morph_targets(const BodyPlan& bust, Body& body) {
  asset::Asset& asset = body.asset;
  const Expressions expressions(bust);
  asset.morph_begin.push_back(0);
  for (std::size_t e = 0; e < kExpressions; ++e) {
    asset.morph_targets.push_back({kExpressionNames[e], 0, 0});
    for (std::uint32_t v = 0; v < body.positions.size(); ++v) {
      const Vec3d by = expressions.displacement(static_cast<Expression>(e), body.positions[v]);
      const Vec3 rounded = to_float(by);
      if (rounded == Vec3()) continue;
      asset.morph_vertices.push_back(v);
      asset.morph_displacements.push_back(rounded);
    }
    asset.morph_begin.push_back(static_cast<std::uint32_t>(asset.morph_vertices.size()));
  }
}

}  // namespace

Result<asset::Asset> make_face(const FaceOptions& options) {
  const std::string problem = check_range("face", "triangles", options.triangles, 1000, 200000);
  if (!problem.empty()) return Error{ErrorCode::invalid_argument, problem};
  const BodyPlan bust = bust_of(make_body_plan(draw_proportions(options.seed)));
  Body body = grow_body(bust, joints_of(bust), options.triangles / 2 * 2, "face");
  add_morph_targets(bust, body);
  body.asset.clips.push_back(talk_clip(bust, body.nodes));
  return std::move(body.asset);
}

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
