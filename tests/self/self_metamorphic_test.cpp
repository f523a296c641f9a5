/// How answers must change when a mesh or its pose changes.

#include <pelt/self_filter.hpp>

#include "self_brute_force.hpp"
#include "support/instruction_sets.hpp"
#include "support/pinned_shapes.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace pelt::test {
namespace {

using Palette = std::vector<Matrix4>;
using Contacts = std::vector<Contact>;

struct Posed {
  Shape shape;
  Palette palette;
};

Pose pose_of(const Posed& posed) {
  Pose pose(*build_model(posed.shape.view()));
  EXPECT_TRUE(pose.set_palette(posed.palette));
  return pose;
}

Contacts self_contacts(const Posed& posed) {
  Pose pose = pose_of(posed);
  Scratch scratch;
  return self_contacts_of(pose, *build_self_filter(pose.model()), scratch);
}

Contact ordered(std::uint32_t s, std::uint32_t t) { return {std::min(s, t), std::max(s, t)}; }

Posed folded_limb(Random& random) {
  return {make_limb(30, 9, 6), bend_limb(random, 6, random.uniform(1, 1.6), {})};
}

Posed soup(Random& random) {
  return {make_soup(random, 150, 6, 4, Weights::random),
          make_palette(random, 6, Motion::affine, 0.5)};
}

Posed grid_soup(Random& random) {
  return {make_grid_soup(random, 120, 4, 6), make_palette(random, 6, Motion::rigid, 0.5)};
}

/// Splits the corners of a limb. Half of the joints move together, so that some cracks stay closed.
Posed cracked_limb(Random& random) {
  Posed posed = {make_limb(14, 7, 6), bend_limb(random, 6, random.uniform(0.1, 1.5), {})};
  split_corners(random, posed.shape, 0.3, 0.3);
  for (std::size_t j = 0; j < 3; ++j) posed.palette[j] = posed.palette[0];
  return posed;
}

constexpr Posed (*kBodies[])(Random&) = {folded_limb, soup, grid_soup, cracked_limb};

/// Calls `test` with posed bodies. It returns how many contacts it has compared.
template <typename Test>
void on_bodies(std::uint64_t seed, const Test& test) {
  Random random(seed);
  for (const auto make : kBodies) {
    std::size_t compared = 0;
    for (int round = 0; round < 8; ++round) compared += test(random, make(random));
    EXPECT_GT(compared, 100u);
  }
}

/// One of two parts of a mesh.
struct Part {
  Shape shape;
  std::vector<std::uint32_t> numbers;  // in the whole mesh

  void add(const Shape& whole, std::uint32_t triangle) {
    shape.triangles.push_back(whole.triangles[triangle]);
    numbers.push_back(triangle);
  }
};

std::array<Part, 2> cut(Random& random, const Shape& whole) {
  std::array<Part, 2> parts;
  for (Part& part : parts) {
    part.shape = whole;
    part.shape.triangles.clear();
  }
  const bool at_random = random.chance(0.5);
  const auto count = static_cast<std::uint32_t>(whole.triangles.size());
  for (std::uint32_t t = 0; t < count; ++t)
    parts[at_random ? random.index(2) : t > count / 2].add(whole, t);
  return parts;
}

Contacts pair_contacts(const Posed& a, const Posed& b) {
  Pose pose_a = pose_of(a), pose_b = pose_of(b);
  Scratch scratch;
  Contacts contacts;
  collide(pose_a, pose_b, scratch, contacts);
  return contacts;
}

bool share_vertex(const std::vector<std::uint32_t>& surface, const Triangle& s, const Triangle& t) {
  for (const std::uint32_t v : s)
    for (const std::uint32_t w : t)
      if (surface[v] == surface[w]) return true;
  return false;
}

TEST(SelfMetamorphic, TwoPartsHaveTheContactsOfTheWhole) {
  on_bodies(1750, [](Random& random, const Posed& whole) {
    const std::array<Part, 2> parts = cut(random, whole.shape);
    std::set<Contact> within, across;
    for (const Part& part : parts)
      for (const Contact& c : self_contacts({part.shape, whole.palette}))
        within.insert({part.numbers[c.triangle_a], part.numbers[c.triangle_b]});
    const Posed first = {parts[0].shape, whole.palette}, second = {parts[1].shape, whole.palette};
    for (const Contact& c : pair_contacts(first, second))
      across.insert(ordered(parts[0].numbers[c.triangle_a], parts[1].numbers[c.triangle_b]));

    // Neighbours across the cut always touch as two poses; as one, they may.
    const auto surface = surface_vertices(whole.shape);
    const auto triangles = posed_triangles(whole.shape.view(), surface, pose_of(whole));
    std::set<Contact> expected = within;
    for (const Contact& c : across)
      if (!share_vertex(surface, whole.shape.triangles[c.triangle_a],
                        whole.shape.triangles[c.triangle_b]) ||
          surface_triangles_intersect(triangles[c.triangle_a], triangles[c.triangle_b]))
        expected.insert(c);
    EXPECT_EQ(self_contacts(whole), Contacts(expected.begin(), expected.end()));
    return expected.size() - within.size();
  });
}

/// A random order of the numbers below `count`.
std::vector<std::uint32_t> shuffled(Random& random, std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[random.index(static_cast<std::uint32_t>(i))]);
  return order;
}

TEST(SelfMetamorphic, TheOrderOfTrianglesAndCornersDoesNotMatter) {
  on_bodies(1751, [](Random& random, const Posed& body) {
    const auto order = shuffled(random, body.shape.triangles.size());
    Posed other = body;
    for (std::uint32_t t = 0; t < order.size(); ++t) {
      const auto corners = shuffled(random, 3);
      for (std::size_t k = 0; k < 3; ++k)
        other.shape.triangles[t][k] = body.shape.triangles[order[t]][corners[k]];
    }
    Contacts found;
    for (const Contact& c : self_contacts(other))
      found.push_back(ordered(order[c.triangle_a], order[c.triangle_b]));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, self_contacts(body));
    return found.size();
  });
}

/// Multiplies the posed coordinates by powers of two and -1, and exchanges the axes.
Palette moved(Random& random, Palette palette) {
  const auto axes = shuffled(random, 3);
  const int exponent = static_cast<int>(random.index(60)) - 30;
  float scales[3];
  for (float& scale : scales) scale = std::ldexp(random.chance(0.5) ? 1.0f : -1.0f, exponent);
  for (Matrix4& joint : palette) {
    const Matrix4 before = joint;
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t row = 0; row < 3; ++row)
        joint.m[4 * column + row] = scales[row] * before.m[4 * column + axes[row]];
  }
  return palette;
}

TEST(SelfMetamorphic, ExactScalesReflectionsAndExchangedAxesDoNotMatter) {
  on_bodies(1752, [](Random& random, const Posed& body) {
    const Contacts found = self_contacts({body.shape, moved(random, body.palette)});
    EXPECT_EQ(found, self_contacts(body));
    return found.size();
  });
}

TEST(SelfMetamorphic, ExactTranslationsDoNotMatter) {
  Random random(1753);
  std::size_t contacts = 0;
  for (int round = 0; round < 100; ++round) {
    const Shape shape = make_pinned(48, torus(8, 6));
    const int exponent = static_cast<int>(random.index(80)) - 40;
    const Vec3 by = {static_cast<float>(random.index(1 << 20)), -static_cast<float>(1 << 19),
                     static_cast<float>(random.index(1 << 20))};
    std::vector<Vec3> positions(48), others;
    for (Vec3& p : positions) {
      p = {static_cast<float>(random.index(9)), static_cast<float>(random.index(9)),
           static_cast<float>(random.index(5))};
      others.push_back({std::ldexp(p.x + by.x, exponent), std::ldexp(p.y + by.y, exponent),
                        std::ldexp(p.z + by.z, exponent)});
    }
    const Contacts found = self_contacts({shape, pin(others)});
    EXPECT_EQ(found, self_contacts({shape, pin(positions)}));
    contacts += found.size();
  }
  EXPECT_GT(contacts, 10'000u);
}

/// Two triangles that share an edge. Each has vertices of its own there, which follow other joints.
Shape two_triangles_with_a_crack() {
  Shape shape;
  shape.influences_per_vertex = 1;
  shape.joint_count = 2;
  for (const std::uint16_t joint : {std::uint16_t{0}, std::uint16_t{1}}) {
    add_vertex(shape, {0, 0, 0}, joint);
    add_vertex(shape, {1, 0, 0}, joint);
    add_vertex(shape, {0.5f, joint == 0 ? 1.0f : -1.0f, 0}, joint);
  }
  shape.triangles = {{0, 1, 2}, {4, 3, 5}};
  return shape;
}

TEST(SelfMetamorphic, CracksThatOpenAreNoNeighbours) {
  const Shape shape = two_triangles_with_a_crack();
  const auto is_hit_after = [&](float x, float y) {
    Palette palette(2);
    palette[1].m[12] = x;
    palette[1].m[13] = y;
    return !self_contacts({shape, palette}).empty();
  };
  EXPECT_FALSE(is_hit_after(0, 0)) << "closed";
  EXPECT_FALSE(is_hit_after(0, -0x1p-30f)) << "opened";
  EXPECT_TRUE(is_hit_after(0, 0x1p-20f)) << "overlapping";
  EXPECT_TRUE(is_hit_after(0x1p-20f, 0)) << "shifted along the edge: they touch, sharing nothing";
  EXPECT_FALSE(is_hit_after(1.5f, 0)) << "apart";
}

TEST(SelfMetamorphic, CracksOfLimbsEqualBruteForce) {
  on_each_instruction_set([](InstructionSet) {
    Random random(1755);
    std::size_t contacts = 0;
    for (int round = 0; round < 12; ++round) {
      const Posed body = cracked_limb(random);
      const Contacts expected = brute_force_self(body.shape, pose_of(body));
      EXPECT_EQ(self_contacts(body), expected);
      EXPECT_TRUE(self_contacts({body.shape, Palette(6)}).empty()) << "closed in the rest pose";
      contacts += expected.size();
    }
    EXPECT_GT(contacts, 300u);
  });
}

}  // namespace
}  // namespace pelt::test
