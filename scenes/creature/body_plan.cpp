#include "scenes/creature/body_plan.hpp"

#include "base/assert.hpp"
#include "scenes/creature/random.hpp"

#include <algorithm>

namespace pelt::scenes {
namespace {

constexpr double kHeight = 1.8;

/// Records joints and muscles. Coordinates are those of a creature of medium proportions.
class Sculptor {
 public:
  explicit Sculptor(const Proportions& proportions) : p_(proportions) {}

  BodyPlan sculpt() {
    sculpt_torso();
    sculpt_head();
    sculpt_tail();
    for (double side : {1.0, -1.0}) {
      side_ = side;
      sculpt_ear();
      sculpt_leg();
      sculpt_foot();
      sculpt_arm();
      sculpt_hand();
    }
    PELT_ASSERT(plan_.joints.size() == kPlanJoints);
    return std::move(plan_);
  }

 private:
  std::uint32_t joint(const std::string& name, std::uint32_t parent, const Vec3d& position) {
    plan_.joints.push_back({name, parent, position});
    return static_cast<std::uint32_t>(plan_.joints.size() - 1);
  }

  std::uint32_t side_joint(const std::string& name, std::uint32_t parent, const Vec3d& position) {
    return joint(name + (side_ > 0 ? "_l" : "_r"), parent, position);
  }

  void limb(double blend) {
    plan_.flesh.limbs.emplace_back();
    plan_.flesh.limbs.back().blend = blend;
  }

  void cone(std::uint32_t owner, const Vec3d& a, double radius_a, const Vec3d& b, double radius_b,
            double blend) {
    plan_.flesh.limbs.back().muscles.push_back({owner, {a, radius_a, b, radius_b}, blend, {}});
  }

  void ball(std::uint32_t owner, const Vec3d& centre, double radius, double blend) {
    cone(owner, centre, radius, centre, radius, blend);
  }

  /// A blunt spike on the back.
  void spike(std::uint32_t owner, const Vec3d& root, const Vec3d& direction, double size) {
    cone(owner, root, size, root + 1.6 * size * direction, 0.35 * size, 0.03);
  }

  /// A point of the side being sculpted; x is the distance from the middle.
  Vec3d out(double x, double y, double z) const { return {side_ * x, y, z}; }

  Vec3d at(std::uint32_t joint) const { return plan_.joints[joint].position; }

  double head_scale() const { return 1.18 * p_.head; }

  void sculpt_torso();
  void sculpt_head();
  void sculpt_tail();
  void sculpt_ear();
  void sculpt_leg();
  void sculpt_foot();
  void sculpt_arm();
  void sculpt_hand();
  void sculpt_finger(const std::string& name, int segments, const Vec3d& knuckle,
                     const Vec3d& direction, double length, double radius);

  Proportions p_;
  BodyPlan plan_;
  double side_ = 1;
  std::uint32_t hips_ = 0, chest_ = 0, head_ = 0, foot_ = 0, hand_ = 0;
};

void Sculptor::sculpt_torso() {
  const double h = 0.70 * p_.leg, g = p_.girth;
  hips_ = joint("hips", kNone, {0, h, 0});
  const std::uint32_t spine_1 = joint("spine_1", hips_, {0, h + 0.11, 0});
  const std::uint32_t spine_2 = joint("spine_2", spine_1, {0, h + 0.22, -0.005});
  chest_ = joint("chest", spine_2, {0, h + 0.33, -0.02});
  limb(0.05);
  cone(hips_, {-0.07, h + 0.01, -0.015}, 0.125 * g, {0.07, h + 0.01, -0.015}, 0.125 * g, 0.08);
  ball(hips_, {0.085, h - 0.03, -0.07}, 0.095 * g, 0.08);
  ball(hips_, {-0.085, h - 0.03, -0.07}, 0.095 * g, 0.08);
  ball(spine_1, {0, h + 0.13, 0.045 * g}, 0.165 * g, 0.10);
  cone(spine_2, {-0.05, h + 0.25, 0.015}, 0.15 * g, {0.05, h + 0.25, 0.015}, 0.15 * g, 0.10);
  cone(chest_, {-0.085, h + 0.37, -0.005}, 0.14 * g, {0.085, h + 0.37, -0.005}, 0.14 * g, 0.10);
  cone(chest_, {-0.14 * g, h + 0.46, -0.03}, 0.07, {0.14 * g, h + 0.46, -0.03}, 0.07, 0.10);
  for (double side : {1.0, -1.0}) {
    cone(chest_, {side * 0.045, h + 0.375, 0.085}, 0.058, {side * 0.10, h + 0.395, 0.06}, 0.055,
         0.05);
  }
  spike(spine_1, {0, h + 0.10, -0.115 * g}, unit({0, 0.35, -1}), 0.045);
  spike(spine_2, {0, h + 0.235, -0.125 * g}, unit({0, 0.4, -1}), 0.05);
  spike(chest_, {0, h + 0.37, -0.135 * g}, unit({0, 0.5, -1}), 0.052);
  spike(chest_, {0, h + 0.485, -0.085}, unit({0, 0.7, -1}), 0.045);
}

void Sculptor::sculpt_head() {
  const double k = head_scale();
  const std::uint32_t neck_1 = joint("neck_1", chest_, at(chest_) + Vec3d(0, 0.17, 0));
  const std::uint32_t neck_2 = joint("neck_2", neck_1, at(neck_1) + Vec3d(0, 0.055, 0.025));
  head_ = joint("head", neck_2, at(neck_2) + Vec3d(0, 0.06, 0.03));
  const Vec3d o = at(head_);
  const auto on = [&](double x, double y, double z) { return o + k * Vec3d(x, y, z); };
  const std::uint32_t jaw = joint("jaw", head_, on(0, 0.045, 0.02));
  const double reach = 0.10 + 0.11 * p_.snout;
  plan_.head = {o, k, reach};

  limb(0.06);
  cone(neck_1, at(neck_1) - Vec3d(0, 0.05, 0.01), 0.105, at(neck_2), 0.09, 0.07);
  cone(neck_2, at(neck_2), 0.09, on(0, 0.04, 0.0), 0.085, 0.06);
  cone(head_, on(0, 0.16, -0.03), 0.135 * k, on(0, 0.15, 0.03), 0.13 * k, 0.06);
  cone(head_, on(-0.035, 0.09, 0.08), 0.075 * k, on(-0.025, 0.085, reach), 0.048 * k, 0.04);
  cone(head_, on(0.035, 0.09, 0.08), 0.075 * k, on(0.025, 0.085, reach), 0.048 * k, 0.04);
  ball(head_, on(0, 0.115, reach + 0.025), 0.032 * k, 0.03);
  cone(head_, on(-0.075, 0.215, 0.085), 0.026 * k, on(0.075, 0.215, 0.085), 0.026 * k, 0.05);
  for (double side : {1.0, -1.0}) {
    ball(head_, on(side * 0.085, 0.09, 0.04), 0.06 * k, 0.06);
    ball(head_, on(side * 0.064, 0.166, 0.124), 0.041 * k, 0.010);
  }
  spike(head_, on(0, 0.26, -0.06), unit({0, 1, -0.35}), 0.042 * k);
  spike(head_, on(0, 0.17, -0.14), unit({0, 0.5, -1}), 0.04 * k);
  limb(0.018);
  cone(jaw, on(0, 0.035, 0.02), 0.075 * k, on(0, 0.022, reach - 0.035), 0.052 * k, 0.03);
}

void Sculptor::sculpt_tail() {
  constexpr int kSegments = 8;
  const auto centre = [&](double t) {
    const double y = at(hips_).y + 0.035 - 0.40 * t + (0.42 + 0.08 * p_.tail) * t * t;
    return Vec3d(0, y, -0.10 - 0.66 * p_.tail * t);
  };
  const auto radius = [](double t) { return 0.105 - 0.083 * t; };
  limb(0.08);
  std::uint32_t parent = hips_;
  for (int s = 0; s < kSegments; ++s) {
    const double t = s / double{kSegments}, next = (s + 1) / double{kSegments};
    parent = joint("tail_" + std::to_string(s + 1), parent, centre(t));
    cone(parent, centre(t), radius(t), centre(next), radius(next), 0.02);
    if (s < 1) continue;
    const Vec3d up = unit(cross({1, 0, 0}, centre(next) - centre(t)));
    spike(parent, mix(centre(t), centre(next), 0.5) + 0.7 * radius(t) * up, up, 0.6 * radius(t));
  }
}

void Sculptor::sculpt_ear() {
  const double k = head_scale(), length = 0.19 * p_.ear;
  const Vec3d root = at(head_) + k * out(0.115, 0.215, -0.02);
  const Vec3d direction = unit(out(0.78, 0.55, -0.28));
  const Vec3d middle = root + 0.5 * length * direction;
  const Vec3d tip = root + length * direction;
  const Vec3d lobe = Vec3d(0, -0.030, 0.012);
  const std::uint32_t ear_1 = side_joint("ear_1", head_, root);
  const std::uint32_t ear_2 = side_joint("ear_2", ear_1, middle);
  limb(0.035);
  cone(ear_1, root, 0.036 * k, middle, 0.032 * k, 0.02);
  cone(ear_1, root + lobe, 0.034 * k, middle + lobe, 0.028 * k, 0.03);
  cone(ear_2, middle, 0.032 * k, tip, 0.013 * k, 0.02);
  cone(ear_2, middle + lobe, 0.028 * k, tip, 0.013 * k, 0.03);
}

void Sculptor::sculpt_leg() {
  const double h = at(hips_).y, g = p_.girth;
  const std::uint32_t thigh = side_joint("thigh", hips_, out(0.112 * g, h - 0.03, 0));
  const std::uint32_t shin = side_joint("shin", thigh, out(0.128 * g, 0.53 * h, 0.025));
  foot_ = side_joint("foot", shin, out(0.135 * g, 0.085, -0.025));
  const Vec3d hip = at(thigh), knee = at(shin), ankle = at(foot_);
  limb(0.06);
  cone(thigh, hip, 0.118 * g, knee, 0.076 * g, 0.05);
  cone(thigh, mix(hip, knee, 0.15) + Vec3d(0, 0, 0.03), 0.10 * g, mix(hip, knee, 0.6), 0.085 * g,
       0.05);
  cone(shin, knee, 0.074 * g, ankle, 0.05, 0.05);
  cone(shin, mix(knee, ankle, 0.2) - Vec3d(0, 0, 0.028), 0.066 * g,
       mix(knee, ankle, 0.55) - Vec3d(0, 0, 0.018), 0.052, 0.05);
}

void Sculptor::sculpt_foot() {
  const double k = 1.1 * p_.foot;
  const Vec3d ankle = at(foot_);
  const auto on = [&](double x, double y, double z) {
    return Vec3d(ankle.x, 0, ankle.z) + k * out(x, y, z);
  };
  const std::uint32_t toes = side_joint("toes", foot_, on(0.018, 0.04, 0.125));
  cone(foot_, ankle, 0.05, on(0, 0.045, -0.03), 0.052 * k, 0.04);
  cone(foot_, on(-0.012, 0.045, 0.0), 0.052 * k, on(-0.016, 0.036, 0.115), 0.046 * k, 0.04);
  cone(foot_, on(0.016, 0.045, 0.0), 0.05 * k, on(0.05, 0.034, 0.105), 0.044 * k, 0.04);
  const double spread[] = {-0.032, 0.02, 0.07};
  const double length[] = {0.085, 0.088, 0.07};
  const char* names[] = {"toe_inner", "toe_middle", "toe_outer"};
  for (int toe = 0; toe < 3; ++toe) {
    const double reach = 0.135 - 0.15 * spread[toe] * (toe == 2 ? 1.0 : 0.3);
    const Vec3d root = on(spread[toe], 0.034, reach - 0.02);
    const Vec3d tip = on(spread[toe] * 1.05, 0.031, reach - 0.02 + length[toe]);
    const std::uint32_t joint = side_joint(names[toe], toes, root);
    limb(0.022);
    cone(toes, on(spread[toe] * 0.8, 0.036, 0.09), 0.036 * k, root, 0.034 * k, 0.02);
    cone(joint, root, 0.034 * k, tip, 0.0305 * k, 0.01);
  }
}

void Sculptor::sculpt_arm() {
  const double a = p_.arm, g = p_.girth;
  const Vec3d collar = at(chest_) + out(0.05, 0.125, 0.0);
  const Vec3d shoulder = at(chest_) + out(0.165 * g + 0.038, 0.125, -0.01);
  const Vec3d elbow = shoulder + 0.25 * a * unit(out(0.62, -0.77, -0.05));
  const Vec3d wrist = elbow + 0.235 * a * unit(out(0.58, -0.79, 0.15));
  const std::uint32_t clavicle = side_joint("clavicle", chest_, collar);
  const std::uint32_t upper = side_joint("upper_arm", clavicle, shoulder);
  const std::uint32_t fore = side_joint("fore_arm", upper, elbow);
  hand_ = side_joint("hand", fore, wrist);
  limb(0.09);
  cone(clavicle, collar, 0.07, shoulder, 0.07, 0.05);
  ball(upper, mix(shoulder, elbow, 0.08), 0.077, 0.05);
  cone(upper, shoulder, 0.068, elbow, 0.05, 0.04);
  cone(upper, mix(shoulder, elbow, 0.35) + Vec3d(0, 0.008, 0.014), 0.054,
       mix(shoulder, elbow, 0.7) + Vec3d(0, 0.006, 0.012), 0.047, 0.04);
  cone(fore, elbow, 0.049, mix(elbow, wrist, 0.35), 0.055, 0.04);
  cone(fore, mix(elbow, wrist, 0.35), 0.055, wrist, 0.038, 0.04);
}

void Sculptor::sculpt_hand() {
  const double k = 1.15 * p_.hand;
  const Vec3d wrist = at(hand_);
  const Vec3d along = unit(out(0.55, -0.82, 0.11));
  const Vec3d across = unit(Vec3d(0, 0.10, 1));
  const auto on = [&](double reach, double spread) {
    return wrist + k * (reach * along + spread * across);
  };
  cone(hand_, on(0.01, 0.006), 0.034 * k, on(0.075, 0.030), 0.029 * k, 0.03);
  cone(hand_, on(0.01, -0.006), 0.034 * k, on(0.078, -0.004), 0.029 * k, 0.02);
  cone(hand_, on(0.01, -0.012), 0.032 * k, on(0.072, -0.036), 0.027 * k, 0.02);
  const auto finger = [&](const std::string& name, double reach, double spread, double length) {
    const Vec3d direction = unit(along + (spread * 9.0) * across);
    sculpt_finger(name, 3, on(reach, spread), direction, length * k, 0.024 * k);
  };
  finger("index", 0.085, 0.040, 0.115);
  finger("middle", 0.092, -0.004, 0.125);
  finger("little", 0.080, -0.047, 0.100);
  sculpt_finger("thumb", 2, on(0.03, 0.040), unit(0.62 * along + 0.78 * across), 0.085 * k,
                0.0245 * k);
}

void Sculptor::sculpt_finger(const std::string& name, int segments, const Vec3d& knuckle,
                             const Vec3d& direction, double length, double radius) {
  limb(0.05);
  std::uint32_t parent = hand_;
  for (int s = 0; s < segments; ++s) {
    const double t = s / double(segments), next = (s + 1) / double(segments);
    const Vec3d from = knuckle + t * length * direction;
    const Vec3d to = knuckle + next * length * direction;
    parent = side_joint(name + "_" + std::to_string(s + 1), parent, from);
    cone(parent, from, radius * (1 - 0.22 * t), to, radius * (1 - 0.22 * next), 0.006);
  }
}

void scale_to_height(BodyPlan& plan) {
  double top = 0;
  for (const Limb& limb : plan.flesh.limbs) {
    for (const Muscle& m : limb.muscles) {
      top = std::max({top, m.shape.a.y + m.shape.radius_a, m.shape.b.y + m.shape.radius_b});
    }
  }
  const double scale = kHeight / top;
  plan.head = {scale * plan.head.origin, scale * plan.head.scale, plan.head.snout};
  for (PlanJoint& joint : plan.joints) joint.position = scale * joint.position;
  for (Limb& limb : plan.flesh.limbs) {
    limb.blend *= scale;
    for (Muscle& muscle : limb.muscles) {
      const RoundCone& s = muscle.shape;
      muscle.shape = {scale * s.a, scale * s.radius_a, scale * s.b, scale * s.radius_b};
      muscle.blend *= scale;
    }
  }
  compute_bounds(plan.flesh);
}

/// Whether each joint is `top` or has `top` as an ancestor.
std::vector<bool> branch_of(const BodyPlan& plan, std::uint32_t top) {
  std::vector<bool> in_branch(plan.joints.size());
  for (std::uint32_t j = top; j < plan.joints.size(); ++j) {
    const std::uint32_t parent = plan.joints[j].parent;
    in_branch[j] = j == top || (parent != kNone && in_branch[parent]);
  }
  return in_branch;
}

}  // namespace

Proportions draw_proportions(std::uint32_t seed) {
  SplitMix64 random(seed);
  Proportions p;
  p.leg = random.between(0.80, 1.15);
  p.girth = random.between(0.90, 1.18);
  p.head = random.between(0.82, 1.22);
  p.snout = random.between(0.4, 1.5);
  p.ear = random.between(0.6, 1.7);
  p.arm = random.between(0.92, 1.15);
  p.tail = random.between(0.6, 1.25);
  p.hand = random.between(0.95, 1.25);
  p.foot = random.between(0.92, 1.2);
  return p;
}

BodyPlan make_body_plan(const Proportions& proportions) {
  BodyPlan plan = Sculptor(proportions).sculpt();
  scale_to_height(plan);
  return plan;
}

BodyPlan bust_of(const BodyPlan& plan) {
  const std::uint32_t neck = find_joint(plan, "neck_1");
  const Vec3d ground(0, plan.joints[neck].position.y, 0);
  const std::vector<bool> kept = branch_of(plan, neck);
  std::vector<std::uint32_t> number(plan.joints.size(), kNone);
  BodyPlan bust;
  for (std::uint32_t j = 0; j < plan.joints.size(); ++j) {
    if (!kept[j]) continue;
    number[j] = static_cast<std::uint32_t>(bust.joints.size());
    const PlanJoint& joint = plan.joints[j];
    bust.joints.push_back(
        {joint.name, j == neck ? kNone : number[joint.parent], joint.position - ground});
  }
  for (Limb limb : plan.flesh.limbs) {
    if (!kept[limb.muscles.front().joint]) continue;
    for (Muscle& muscle : limb.muscles) {
      muscle.joint = number[muscle.joint];
      muscle.shape.a = muscle.shape.a - ground;
      muscle.shape.b = muscle.shape.b - ground;
    }
    bust.flesh.limbs.push_back(std::move(limb));
  }
  compute_bounds(bust.flesh);
  bust.head = plan.head;
  bust.head.origin = plan.head.origin - ground;
  return bust;
}

std::uint32_t find_joint(const BodyPlan& plan, const std::string& name) {
  for (std::uint32_t j = 0; j < plan.joints.size(); ++j) {
    if (plan.joints[j].name == name) return j;
  }
  PELT_ASSERT(false);
  return kNone;
}

}  // namespace pelt::scenes
