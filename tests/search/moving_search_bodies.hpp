#pragma once

/// Pairs of moving bodies for tests of searches for the first contact.

#include "motion/bodies.hpp"
#include "search/search_bodies.hpp"

#include <pelt/first_contact_search.hpp>

#include <utility>
#include <vector>

namespace pelt::test {

/// Calls `body(a, b)` for limbs that move by different distances, and for soups of this size.
template <typename Test>
void for_moving_bodies(Random& random, int rounds, std::uint32_t soup_triangles, const Test& body) {
  Limbs limbs;
  for (int round = 0; round < rounds; ++round) {
    limbs.move(random, round % 2 ? 0.12 : 0.6);
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
