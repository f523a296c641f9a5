/// Runs the programs of docs/queries.md, and the eight lines of the README.

#include "support/skinned_shapes.hpp"

#include <pelt/pelt.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

// Defined in docs/examples.
void print_contacts(const pelt::SkinnedMeshView& mesh, std::span<const pelt::Matrix4> palette_a,
                    std::span<const pelt::Matrix4> palette_b);

// Defined in docs/examples/queries.
pelt::Sphere sphere_around(pelt::Pose& pose, std::span<const pelt::Matrix4> palette);
pelt::Box smallest_box(pelt::Pose& pose);
bool is_seen(pelt::Pose& pose, const pelt::Matrix4& view_projection, pelt::Scratch& scratch);
std::vector<std::uint32_t> brushed(pelt::Pose& pose, const pelt::Sphere& brush,
                                   pelt::Scratch& scratch);
int picked_joint(pelt::Pose& pose, const pelt::Vec3& eye, const pelt::Vec3& far_away);
double gap(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch, pelt::Distance& closest);
pelt::Vec3 closest_position(pelt::Pose& pose, const pelt::Vec3& target, pelt::Scratch& scratch);
std::vector<pelt::ContactPatch> pushes(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch);
double depth_in(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch);
double share_inside(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch);
float first_touch(pelt::Motion sword, pelt::Motion arm, pelt::Scratch& scratch);
std::vector<pelt::MovingContact> new_touches(pelt::Motion sword, pelt::Motion arm,
                                             pelt::Scratch& scratch);
std::vector<pelt::MovingContact> new_self_contacts(pelt::Motion motion,
                                                   const pelt::SelfFilter& filter,
                                                   pelt::Scratch& scratch);
float free_part(pelt::Motion a, pelt::Motion b, std::uint64_t work);
bool touch_before(pelt::Motion a, pelt::Motion b, float time);
std::vector<pelt::RegionEntry> entered(pelt::Motion motion, const pelt::Sphere& trigger,
                                       pelt::Scratch& scratch);
bool pose_rigid_joints(const pelt::SkinnedMeshView& mesh, std::span<const float> dual_quaternions);
bool pose_face(pelt::Pose& pose, std::span<const pelt::Matrix4> palette,
               std::span<const float> weights);
pelt::Result<pelt::SkinnedModel> cloth(std::span<const pelt::Vec3> rest,
                                       std::span<const pelt::Triangle> triangles);
bool touches(pelt::Pose& cloth, std::span<const pelt::Vec3> vertices, pelt::Pose& body,
             pelt::Scratch& scratch);
bool add_wrinkles(pelt::Pose& body, std::span<const pelt::Vec3> offsets);
std::vector<std::uint32_t> grounded(pelt::Pose& pose, const pelt::HeightField& ground,
                                    pelt::Scratch& scratch);
double from_pillar(pelt::Pose& pose, const pelt::Capsule& pillar, pelt::Scratch& scratch);
pelt::Verdict touch_in_time(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch,
                            const std::function<bool()>& has_time);
pelt::OpenRegion least_known(const pelt::CollisionSearch& search);
pelt::Result<pelt::SelfFilter> only_new(pelt::Pose& rest, pelt::Scratch& scratch);
std::vector<pelt::ContactPatch> cuts(pelt::Pose& pose, const pelt::SelfFilter& filter,
                                     pelt::Scratch& scratch, pelt::LeftOut& left_out);
void find_self_contacts(pelt::Pose& pose, pelt::SelfTracker& tracker, pelt::Scratch& scratch,
                        std::vector<pelt::Contact>& contacts);

namespace pelt::test {
namespace {

/// A limb from y = 0 to y = 1 along the axis, translated along x.
class QueryExamples : public ::testing::Test {
 protected:
  static SkinnedModel limb() { return *build_model(make_limb(16, 12, 3).view()); }

  static std::vector<Matrix4> moved(float x) {
    std::vector<Matrix4> palette(3);
    for (Matrix4& m : palette) m.m[12] = x;
    return palette;
  }

  Pose pose_{limb()};
  Scratch scratch_;
};

TEST_F(QueryExamples, EightLines) {
  const auto mesh = make_limb(16, 12, 3);
  ::testing::internal::CaptureStdout();
  print_contacts(mesh.view(), moved(0), moved(0.05f));
  const std::string printed = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(printed.find("triangle "), 0u);
  EXPECT_GT(std::count(printed.begin(), printed.end(), '\n'), 10);
}

TEST_F(QueryExamples, Bounds) {
  const Sphere sphere = sphere_around(pose_, moved(5));
  const Box box = smallest_box(pose_);
  EXPECT_GT(sphere.radius, 0.4f);
  EXPECT_LT(sphere.radius, 2);
  EXPECT_NEAR(sphere.centre.x, 5, 0.1);
  EXPECT_NEAR(box.low.x + box.high.x, 10, 0.01);
}

TEST_F(QueryExamples, Culling) {
  EXPECT_TRUE(is_seen(pose_, Matrix4(), scratch_));  // everything is between -1 and 1
  ASSERT_TRUE(pose_.set_palette(moved(5)));
  EXPECT_FALSE(is_seen(pose_, Matrix4(), scratch_));
  EXPECT_TRUE(brushed(pose_, {{0, 0.5f, 0}, 1}, scratch_).empty());
  const std::size_t triangles = pose_.model().triangle_count();
  EXPECT_EQ(brushed(pose_, {{5, 0.5f, 0}, 2}, scratch_).size(), triangles);
}

TEST_F(QueryExamples, Ray) {
  EXPECT_EQ(picked_joint(pose_, {-3, 0.05f, 0.01f}, {3, 0.05f, 0.01f}), 0);
  EXPECT_EQ(picked_joint(pose_, {-3, 0.95f, 0.01f}, {3, 0.95f, 0.01f}), 2);
  EXPECT_EQ(picked_joint(pose_, {-3, 5, 0}, {3, 5, 0}), -1);
}

TEST_F(QueryExamples, Distance) {
  Pose other(limb());
  ASSERT_TRUE(other.set_palette(moved(3)));
  Distance closest;
  const double first = gap(pose_, other, scratch_, closest);
  EXPECT_GT(first, 2);
  EXPECT_LT(first, 3);
  EXPECT_EQ(gap(pose_, other, scratch_, closest), first);
  const Vec3 position = closest_position(pose_, {9, 0.5f, 0}, scratch_);
  EXPECT_NEAR(position.x, closest.a.position.x, 0.01);
}

TEST_F(QueryExamples, Search) {
  Pose other(limb());
  ASSERT_TRUE(other.set_palette(moved(0.05f)));
  EXPECT_EQ(touch_in_time(pose_, other, scratch_, [] { return false; }), Verdict::unknown);
  EXPECT_EQ(touch_in_time(pose_, other, scratch_, [] { return true; }), Verdict::touching);
  CollisionSearch search(pose_, other, SearchOrder::resolution);
  EXPECT_EQ(least_known(search).pairs, search.undecided_pairs());
  search.advance(1000, scratch_);
  EXPECT_LT(least_known(search).pairs, search.undecided_pairs());
}

TEST_F(QueryExamples, Contact) {
  Pose other(limb());
  ASSERT_TRUE(other.set_palette(moved(3)));
  EXPECT_TRUE(pushes(pose_, other, scratch_).empty());
  ASSERT_TRUE(other.set_palette(moved(0.05f)));
  const auto patches = pushes(pose_, other, scratch_);
  ASSERT_FALSE(patches.empty());
  EXPECT_GT(patches[0].depth, 0);
}

TEST_F(QueryExamples, SelfCollide) {
  // Two limbs in one mesh, which intersect at the lower ends at rest.
  Shape shape = make_limb(16, 12, 1);
  const auto first = static_cast<std::uint32_t>(shape.rest_positions.size());
  const std::vector<Triangle> triangles = shape.triangles;
  for (std::uint32_t v = 0; v < first; ++v) {
    const Vec3 at = shape.rest_positions[v];
    shape.rest_positions.push_back({at.x + 0.06f + 0.5f * at.y, at.y, at.z + 0.01f});
  }
  for (const Triangle& t : triangles)
    shape.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  shape.joint_count = 2;
  shape.joints.resize(2 * shape.joints.size(), 1);
  shape.weights.insert(shape.weights.end(), shape.weights.begin(), shape.weights.end());

  Pose pose(*build_model(shape.view()));
  const Result<SelfFilter> filter = only_new(pose, scratch_);
  ASSERT_TRUE(filter);
  LeftOut left_out;
  EXPECT_TRUE(cuts(pose, *filter, scratch_, left_out).empty());
  EXPECT_GT(left_out.at_rest, 10u);
  std::vector<Matrix4> palette(2);
  palette[1].m[12] = -0.25f;  // moves the second limb into the first
  ASSERT_TRUE(pose.set_palette(palette));
  const auto patches = cuts(pose, *filter, scratch_, left_out);
  ASSERT_FALSE(patches.empty());
  EXPECT_EQ(patches[0].joint_a, 0);
  EXPECT_EQ(patches[0].joint_b, 1);
  SelfTracker tracker(*filter);
  std::vector<Contact> expected, contacts = {Contact{7, 9}};
  self_collide(pose, *filter, scratch_, expected);
  find_self_contacts(pose, tracker, scratch_, contacts);
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(contacts, expected);
}

TEST_F(QueryExamples, Inside) {
  Pose other(limb());
  ASSERT_TRUE(other.model().surface().is_closed());
  ASSERT_TRUE(other.set_palette(moved(3)));
  EXPECT_EQ(depth_in(pose_, other, scratch_), 0);
  ASSERT_TRUE(other.set_palette(moved(0.05f)));
  EXPECT_GT(depth_in(pose_, other, scratch_), 0);
}

TEST_F(QueryExamples, Volume) {
  Pose other(limb());
  EXPECT_NEAR(share_inside(pose_, other, scratch_), 1, 1e-12);
  ASSERT_TRUE(other.set_palette(moved(0.05f)));
  const double share = share_inside(pose_, other, scratch_);
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.9);
  ASSERT_TRUE(other.set_palette(moved(3)));
  EXPECT_EQ(share_inside(pose_, other, scratch_), 0);
}

TEST_F(QueryExamples, Terrain) {
  const std::vector<float> heights(11 * 11);
  const auto ground_at = [&](float y) {
    return *build_height_field({heights, 11, 11, {-5, y, -5}, 1, 1});
  };
  EXPECT_TRUE(grounded(pose_, ground_at(-0.01f), scratch_).empty());
  const std::size_t triangles = grounded(pose_, ground_at(0.01f), scratch_).size();
  EXPECT_GT(triangles, 20u);
  EXPECT_LT(triangles, pose_.model().triangle_count() / 4);

  const Capsule pillar = {{5, -9, 0}, {5, 9, 0}, 1};
  EXPECT_GT(from_pillar(pose_, pillar, scratch_), 3);
  ASSERT_TRUE(pose_.set_palette(moved(5)));
  EXPECT_EQ(from_pillar(pose_, pillar, scratch_), 0);
}

TEST_F(QueryExamples, Morphs) {
  Pose limb(*build_model(make_morphing_limb(16, 12, 3).view()));
  ASSERT_TRUE(pose_face(limb, moved(5), std::vector<float>{0, 0, 0}));
  const Box still = smallest_box(limb);
  ASSERT_TRUE(pose_face(limb, moved(5), std::vector<float>{2, 2, 2}));
  const Box displaced = smallest_box(limb);
  EXPECT_NE(displaced.high.x - displaced.low.x, still.high.x - still.low.x);
  EXPECT_FALSE(pose_face(limb, moved(5), std::vector<float>{2, 2}));
}

TEST_F(QueryExamples, VerticesOfAnotherProgram) {
  const Shape shape = make_limb(16, 12, 3);
  Pose sheet(*cloth(shape.rest_positions, shape.triangles));
  EXPECT_TRUE(touches(sheet, shape.rest_positions, pose_, scratch_));
  std::vector<Vec3> above = shape.rest_positions;
  for (Vec3& p : above) p.y += 5;
  EXPECT_FALSE(touches(sheet, above, pose_, scratch_));

  SkinnedMeshView view = shape.view();
  const std::vector<float> caps(shape.rest_positions.size(), 0.1f);
  view.offset_caps = caps;
  Pose body(*build_model(view));
  EXPECT_TRUE(add_wrinkles(body, std::vector<Vec3>(caps.size(), {0, 0.05f, 0})));
  EXPECT_FALSE(add_wrinkles(body, std::vector<Vec3>(caps.size(), {0, 0.5f, 0})));
}

TEST_F(QueryExamples, Skinning) {
  const Shape limb = make_limb(16, 12, 2);
  EXPECT_TRUE(pose_rigid_joints(
      limb.view(), std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(pose_rigid_joints(limb.view(), std::vector<float>(16)));
}

TEST_F(QueryExamples, Motion) {
  const SkinnedModel model = limb();
  Pose sword(model), sword_later(model);
  ASSERT_TRUE(sword.set_palette(moved(-4)));
  ASSERT_TRUE(sword_later.set_palette(moved(4)));
  ASSERT_FALSE(intersects(sword, pose_, scratch_));
  ASSERT_FALSE(intersects(sword_later, pose_, scratch_));
  const float first = first_touch({sword, sword_later}, {pose_, pose_}, scratch_);
  EXPECT_GT(first, 0.4f);
  EXPECT_LT(first, 0.5f);
  EXPECT_EQ(first_touch({sword, sword}, {pose_, pose_}, scratch_), 2);
  const auto touches = new_touches({sword, sword_later}, {pose_, pose_}, scratch_);
  ASSERT_GT(touches.size(), 10u);
  for (const MovingContact& contact : touches) EXPECT_GE(contact.time, first);
  const auto entries = entered({sword, sword_later}, {{0, 0.5f, 0}, 0.1f}, scratch_);
  ASSERT_GT(entries.size(), 10u);
  for (const RegionEntry& entry : entries) EXPECT_NEAR(entry.time, 0.5f, 0.1f);
  EXPECT_TRUE(entered({sword, sword}, {{0, 0.5f, 0}, 0.1f}, scratch_).empty());
}

TEST_F(QueryExamples, FirstContactSearch) {
  const SkinnedModel model = limb();
  Pose sword(model), sword_later(model);
  ASSERT_TRUE(sword.set_palette(moved(-4)));
  ASSERT_TRUE(sword_later.set_palette(moved(4)));
  const float first = first_touch({sword, sword_later}, {pose_, pose_}, scratch_);
  EXPECT_EQ(free_part({sword, sword_later}, {pose_, pose_}, UINT64_MAX), first);
  const float part = free_part({sword, sword_later}, {pose_, pose_}, 500);
  EXPECT_GT(part, 0);
  EXPECT_LT(part, first);
  EXPECT_TRUE(touch_before({sword, sword_later}, {pose_, pose_}, first + 0.01f));
  EXPECT_FALSE(touch_before({sword, sword_later}, {pose_, pose_}, first - 0.01f));
}

TEST_F(QueryExamples, SelfMotion) {
  const SkinnedModel model = limb();
  const SelfFilter filter = *build_self_filter(model);
  Pose straight(model), inside_out(model);
  ASSERT_TRUE(straight.set_palette(moved(0)));
  std::vector<Matrix4> palette = moved(0);
  for (Matrix4& m : palette) m.m[0] = -1;
  ASSERT_TRUE(inside_out.set_palette(palette));
  EXPECT_TRUE(new_self_contacts({straight, straight}, filter, scratch_).empty());
  const auto contacts = new_self_contacts({straight, inside_out}, filter, scratch_);
  ASSERT_GT(contacts.size(), 100u);
  for (const MovingContact& contact : contacts) EXPECT_EQ(contact.time, 0.5f);
}

}  // namespace
}  // namespace pelt::test
