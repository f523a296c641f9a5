#pragma once

/// Pairs of moving bodies for tests of searches for the first contact.

#include "collide/moving_bodies.hpp"
#include "collide/search_bodies.hpp"

#include <pelt/search.hpp>

#include <utility>
#include <vector>

namespace pelt::test {

/// Moves the second limb fast from one side of the first to the other. Parts of them overlap only
/// for a part of the step.
inline void move_past(Random& random, Limbs& limbs) {
  const Vec3 way = random.point(2), aside = random.point(0.4);
  const auto bend = [&](std::uint32_t joints, const Vec3& place) {
    const double angle = random.uniform(-0.6, 0.6);
    return bend_limb(random, joints, angle, place);
  };
  const auto from_a = bend(4, {}), to_a = bend(4, {});
  const auto from_b = bend(3, {aside.x - way.x, aside.y - way.y, aside.z - way.z});
  const auto to_b = bend(3, {aside.x + way.x, aside.y + way.y, aside.z + way.z});
  limbs.a.move(from_a, to_a);
  limbs.b.move(from_b, to_b);
}

/// Calls `body(a, b)` for limbs that move a little, much or past each other, and for soups of this
/// size.
template <typename Test>
void for_moving_bodies(Random& random, int rounds, std::uint32_t soup_triangles, const Test& body) {
  Limbs limbs;
  for (int round = 0; round < rounds; ++round) {
    round % 2 ? limbs.move(random, round % 4 == 1 ? 0.12 : 0.6) : move_past(random, limbs);
    body(limbs.a, limbs.b);
  }
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed})
    for (const Weights weights : {Weights::random, Weights::adversarial}) {
      Body a(make_soup(random, soup_triangles, 4, 2, weights));
      Body b(make_soup(random, soup_triangles, 4, 2, weights));
      const auto palette = [&] { return make_palette(random, 4, motion, 1); };
      const auto from_a = palette(), to_a = palette(), from_b = palette(), to_b = palette();
      a.move(from_a, to_a);
      b.move(from_b, to_b);
      body(a, b);
    }
}

inline std::optional<MovingContact> first_of(Body& a, Body& b, bool leave_out_start) {
  Scratch scratch;
  std::optional<MovingContact> first;
  first_contact(a.step(), b.step(), scratch, first, {leave_out_start});
  return first;
}

/// Sheets whose posed vertices are the same on every machine. They approach and then cross.
struct CrossingSheets {
  explicit CrossingSheets(std::uint32_t cells = 14) : a(make_sheet(cells)), b(make_sheet(cells)) {
    const auto low = [](std::uint32_t x, std::uint32_t y) { return 0.25f * float(x * y % 7); };
    const auto high = [](std::uint32_t x, std::uint32_t y) {
      return 3 + 0.125f * float(x + y % 5);
    };
    const std::vector<Vec3> still = sheet_positions(cells, low), far = sheet_positions(cells, high);
    std::vector<Vec3> first = far, last = far;
    for (Vec3& p : first) p = {p.x + 0.375f, p.y + 0.1875f, p.z};
    for (Vec3& p : last) p = {p.x + 0.5f, p.y - 0.25f, p.z - 5};
    a.move(pin(still), pin(still));
    b.move(pin(first), pin(last));
  }

  Body a, b;
};

}  // namespace pelt::test
