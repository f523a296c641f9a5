#include "evaluation/rivals/posed_mesh_method.hpp"

#include "evaluation/rivals/posed_bodies.hpp"

#include <gtest/gtest.h>

namespace pelt::rivals {
namespace {

TEST(Hybrid, RefitsLowerBoxesWhereTheQueryGoesAndOncePerUpdate) {
  test::Random random(1);
  const auto make = [&] {
    return test::scattered(
        random, 500, 2, [](test::Random& r) { return r.point(1); },
        [](test::Random&) { return 0.2; });
  };
  const test::PosedBody a = make(), b = make();
  test::Positions aside = b.frames[1];
  for (Vec3& p : aside) p.x += 2;
  const auto method = make_hybrid();
  method->add(a.triangles, a.frames[0]);
  method->add(b.triangles, b.frames[0]);
  std::vector<Contact> contacts;
  const auto refits_after = [&](const test::Positions& positions_b) {
    method->update(0, a.frames[1]);
    method->update(1, positions_b);
    return method->collide(0, 1, contacts, ~0u).refits;
  };

  test::Positions far = b.frames[1];
  for (Vec3& p : far) p.x += 10;
  EXPECT_EQ(refits_after(far), 0u);
  const std::uint64_t some = refits_after(aside), many = refits_after(b.frames[1]);
  EXPECT_GT(some, 0u);
  EXPECT_LT(some, many);
  EXPECT_EQ(method->collide(0, 1, contacts, ~0u).refits, 0u);
  EXPECT_EQ(method->collide(1, 0, contacts, ~0u).refits, 0u);
  method->update(0, a.frames[1]);
  const std::uint64_t one_stale = method->collide(0, 1, contacts, ~0u).refits;
  EXPECT_GT(one_stale, 0u);
  EXPECT_LT(one_stale, many);
}

}  // namespace
}  // namespace pelt::rivals
