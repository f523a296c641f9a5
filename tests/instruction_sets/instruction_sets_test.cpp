/// Every instruction set finds the contacts of brute force with the same work, also where vertices
/// are on planes and edges of other triangles, which only exact arithmetic can decide.

#include <pelt/collide.hpp>
#include <pelt/self.hpp>

#include "exact/predicates.hpp"
#include "self/self_brute_force.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace pelt {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

using Matrices = std::vector<Matrix4>;

struct Body {
  Shape shape;
  Matrices palette;
};

/// Triangles between points of a small integer grid; each vertex follows one joint, or two equal
/// ones.
Shape make_grid_soup(Random& random, std::uint32_t triangle_count, std::uint32_t joint_count) {
  Shape shape;
  shape.joint_count = joint_count;
  shape.influences_per_vertex = 2;
  const auto coordinate = [&] { return static_cast<float>(random.index(5)) - 2; };
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    const auto first = static_cast<std::uint32_t>(shape.rest_positions.size());
    const auto joint = static_cast<std::uint16_t>(random.index(joint_count));
    for (int corner = 0; corner < 3; ++corner) {
      shape.rest_positions.push_back({coordinate(), coordinate(), coordinate()});
      shape.joints.insert(shape.joints.end(),
                          {joint, random.chance(0.2) ? std::uint16_t{0} : joint});
      shape.weights.insert(shape.weights.end(), {0.5f, 0.5f});
    }
    shape.triangles.push_back({first, first + 1, first + 2});
  }
  return shape;
}

/// Rotations by right angles, reflections and translations by whole units, which preserve the grid.
Matrix4 grid_joint(Random& random) {
  std::uint32_t axes[3] = {0, 1, 2};
  std::swap(axes[0], axes[random.index(3)]);
  std::swap(axes[1], axes[1 + random.index(2)]);
  Matrix4 joint;
  joint.m = {};
  for (std::uint32_t column = 0; column < 3; ++column)
    joint.m[4 * column + axes[column]] = random.chance(0.5) ? 1.0f : -1.0f;
  for (std::uint32_t row = 0; row < 3; ++row)
    joint.m[12 + row] = static_cast<float>(random.index(3)) - 1;
  joint.m[15] = 1;
  return joint;
}

/// Sets whole rows to zero: everything is mapped to planes of the grid, lines, or a point.
Matrix4 collapsed(Random& random, Matrix4 joint, double probability) {
  for (std::size_t row = 0; row < 3; ++row)
    if (random.chance(probability))
      for (std::size_t column = 0; column < 4; ++column) joint.m[4 * column + row] = 0;
  return joint;
}

Body on_the_grid(Random& random) {
  Body body{make_grid_soup(random, 60, 4), {}};
  for (int j = 0; j < 4; ++j) body.palette.push_back(grid_joint(random));
  return body;
}

Body collapsed_on_the_grid(Random& random) {
  Body body = on_the_grid(random);
  for (Matrix4& joint : body.palette) joint = collapsed(random, joint, 0.4);
  return body;
}

Body in_one_plane(Random& random) {
  Body body{test::make_soup(random, 60, 4, 3, Weights::random),
            test::make_palette(random, 4, Motion::affine, 0.5)};
  for (Matrix4& joint : body.palette)
    for (std::size_t column = 0; column < 4; ++column) joint.m[4 * column + 2] = 0;
  return body;
}

/// The same limb in the same pose: every triangle coincides with its twin and touches its
/// neighbours.
Body twin(Random&) {
  Random same(90);
  return {test::make_limb(12, 8, 4), test::bend_limb(same, 4, 0.3, {})};
}

Body bent_limb(Random& random) {
  return {test::make_limb(24, 10, 5),
          test::bend_limb(random, 5, random.uniform(-0.6, 0.6), random.point(0.15))};
}

template <Motion kMotion>
Body soup(Random& random) {
  const Weights weights[] = {Weights::one_joint, Weights::random, Weights::adversarial};
  const std::uint32_t influences[] = {1, 4, 12};
  return {test::make_soup(random, 120, 6, influences[random.index(3)], weights[random.index(3)]),
          test::make_palette(random, 6, kMotion, 1)};
}

Body moved(Body body, float distance, float scale) {
  for (Matrix4& joint : body.palette) {
    for (std::size_t e = 0; e < 16; ++e)
      if (e % 4 != 3) joint.m[e] *= scale;
    joint.m[12] += distance;
  }
  return body;
}

Body far_on_the_grid(Random& random) { return moved(on_the_grid(random), 0x1p20f, 1); }
Body tiny_on_the_grid(Random& random) { return moved(on_the_grid(random), 0, 0x1p-70f); }
Body huge_on_the_grid(Random& random) { return moved(on_the_grid(random), 0, 0x1p50f); }

struct Case {
  const char* name;
  Body (*make)(Random&);
  bool needs_exact_signs;
  bool is_smooth = false;  ///< hardly intersects itself
};

constexpr Case kCases[] = {
    {"on_the_grid", on_the_grid, true},
    {"collapsed_on_the_grid", collapsed_on_the_grid, true},
    {"far_on_the_grid", far_on_the_grid, true},
    {"tiny_on_the_grid", tiny_on_the_grid, true},
    {"huge_on_the_grid", huge_on_the_grid, true},
    {"in_one_plane", in_one_plane, true},
    {"twins", twin, true, true},
    {"bent_limbs", bent_limb, false, true},
    {"rigid_soups", soup<Motion::rigid>, false},
    {"affine_soups", soup<Motion::affine>, false},
    {"collapsed_soups", soup<Motion::collapsed>, false},
    {"soups_far_away", soup<Motion::far_away>, false},
};

/// The answer and the work of a query.
struct Answer {
  std::vector<Contact> contacts;
  QueryStats work;
  std::uint64_t exact_signs = 0;
};

auto counts(const QueryStats& work) {
  return std::tuple(work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs,
                    work.cut_short);
}

/// Two bodies that are queried in a new pose each time.
class Pair {
 public:
  Pair(const Body& a, const Body& b)
      : body_a_(a),
        body_b_(b),
        a_(*build_model(a.shape.view())),
        b_(*build_model(b.shape.view())) {}

  Answer collide(std::uint32_t max_contacts) {
    set_palettes();
    Answer answer;
    const std::uint64_t before = detail::exact_sign_count();
    answer.work = pelt::collide(a_, b_, scratch_, answer.contacts, {.max_contacts = max_contacts});
    answer.exact_signs = detail::exact_sign_count() - before;
    return answer;
  }

  std::vector<Contact> brute_force() {
    set_palettes();
    std::vector<Vec3> positions_a(body_a_.shape.rest_positions.size());
    std::vector<Vec3> positions_b(body_b_.shape.rest_positions.size());
    posed_vertices(a_, positions_a);
    posed_vertices(b_, positions_b);
    std::vector<Contact> contacts;
    methods::brute_force_collide(body_a_.shape.triangles, positions_a, body_b_.shape.triangles,
                                 positions_b, contacts, UINT32_MAX);
    return contacts;
  }

 private:
  void set_palettes() {
    ASSERT_TRUE(a_.set_palette(body_a_.palette));
    ASSERT_TRUE(b_.set_palette(body_b_.palette));
  }

  const Body &body_a_, &body_b_;
  Pose a_, b_;
  Scratch scratch_;
};

class InstructionSets : public testing::TestWithParam<Case> {};

TEST_P(InstructionSets, FindWhatBruteForceFindsByTheSameWork) {
  Random random(80);
  std::size_t contacts = 0, pairs = 0;
  std::uint64_t exact_signs = 0;
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    const Body a = GetParam().make(random), b = GetParam().make(random);
    Pair pair(a, b);
    const std::vector<Contact> expected = pair.brute_force();
    Answer first;
    test::on_each_instruction_set([&](InstructionSet set) {
      const Answer answer = pair.collide(UINT32_MAX);
      if (set == available_instruction_sets().front()) first = answer;
      EXPECT_EQ(answer.contacts, expected);
      EXPECT_EQ(counts(answer.work), counts(first.work));
      EXPECT_EQ(answer.exact_signs, first.exact_signs);
    });
    contacts += expected.size();
    pairs += a.shape.triangles.size() * b.shape.triangles.size();
    exact_signs += first.exact_signs;
  }
  std::printf("%zu contacts, %llu exact signs\n", contacts,
              static_cast<unsigned long long>(exact_signs));
  EXPECT_GT(contacts, 100u);
  EXPECT_LT(contacts, pairs);
  if (GetParam().needs_exact_signs) {
    EXPECT_GT(exact_signs, 100u);
  }
}

TEST_P(InstructionSets, StopAtTheLimitAfterTheSameWork) {
  Random random(81);
  int cut_short = 0;
  for (int round = 0; round < 5; ++round)
    for (const std::uint32_t limit : {1u, 7u, 30u}) {
      const Body a = GetParam().make(random), b = GetParam().make(random);
      Pair pair(a, b);
      Answer first;
      test::on_each_instruction_set([&](InstructionSet set) {
        const Answer answer = pair.collide(limit);
        if (set == available_instruction_sets().front()) first = answer;
        EXPECT_EQ(answer.contacts, first.contacts);
        EXPECT_EQ(counts(answer.work), counts(first.work));
      });
      cut_short += first.work.cut_short;
    }
  EXPECT_GT(cut_short, 0);
}

/// One body that is queried in a new pose each time.
class Single {
 public:
  explicit Single(const Body& body)
      : body_(body),
        pose_(*build_model(body.shape.view())),
        filter_(*build_self_filter(pose_.model())) {}

  Answer collide(std::uint32_t max_contacts) {
    EXPECT_TRUE(pose_.set_palette(body_.palette));
    Answer answer;
    const std::uint64_t before = detail::exact_sign_count();
    answer.work =
        self_collide(pose_, filter_, scratch_, answer.contacts, {.max_contacts = max_contacts});
    answer.exact_signs = detail::exact_sign_count() - before;
    return answer;
  }

  std::vector<Contact> brute_force() const { return test::brute_force_self(body_.shape, pose_); }

 private:
  const Body& body_;
  Pose pose_;
  SelfFilter filter_;
  Scratch scratch_;
};

TEST_P(InstructionSets, FindWhatBruteForceFindsInOneBodyByTheSameWork) {
  Random random(82);
  std::size_t contacts = 0;
  for (int round = 0; round < 12; ++round)
    for (const std::uint32_t limit : {UINT32_MAX, 1u, 20u}) {
      SCOPED_TRACE(testing::Message() << "round " << round << ", limit " << limit);
      const Body body = GetParam().make(random);
      Single single(body);
      Answer first;
      test::on_each_instruction_set([&](InstructionSet set) {
        const Answer answer = single.collide(limit);
        if (set == available_instruction_sets().front()) first = answer;
        EXPECT_EQ(answer.contacts, first.contacts);
        EXPECT_EQ(counts(answer.work), counts(first.work));
        EXPECT_EQ(answer.exact_signs, first.exact_signs);
      });
      if (limit < UINT32_MAX) continue;
      EXPECT_EQ(first.contacts, single.brute_force());
      contacts += first.contacts.size();
    }
  std::printf("%zu contacts\n", contacts);
  if (!GetParam().is_smooth) {
    EXPECT_GT(contacts, 100u);
  }
}

INSTANTIATE_TEST_SUITE_P(Inputs, InstructionSets, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace pelt
