/// Tables of cells stay as small as the mesh, even if triangles are large compared to the mean
/// edge.

#include "evaluation/rivals/posed_bodies.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"
#include "support/allocation_count.hpp"

#include <gtest/gtest.h>

namespace pelt::rivals {
namespace {

TEST(HashMemory, IsBoundedWhereTrianglesTouchMillionsOfCells) {
  test::Random random(1);
  constexpr std::uint32_t kTriangles = 2000;
  const auto make = [&] {
    return test::scattered(
        random, kTriangles, 2, [](test::Random& r) { return r.point(1); },
        [](test::Random&) { return 0.01; });
  };
  test::PosedBody a = make(), b = make();
  for (test::PosedBody* body : {&a, &b})  // tiny at rest; then every tenth triangle is stretched
    for (std::size_t v = 0; v < body->frames[1].size(); v += 30)
      body->frames[1][v] = {random.uniformf(-1e3, 1e3), random.uniformf(-1e3, 1e3), 1e3f};
  const std::size_t before = test::largest_allocation();
  ASSERT_LT(before, kTriangles * 1000);
  for (const auto make_method : {make_hash, make_hash_overlap, make_hash_crowd}) {
    const auto method = make_method({});
    method->add(a.triangles, a.frames[0]);
    method->add(b.triangles, b.frames[0]);
    method->update(0, a.frames[1]);
    method->update(1, b.frames[1]);
    std::vector<Contact> contacts;
    method->collide(0, 1, contacts, ~0u);
    EXPECT_FALSE(contacts.empty());
  }
  std::printf("largest allocation: %zu bytes\n", test::largest_allocation());
  EXPECT_LT(test::largest_allocation(), kTriangles * 64 * 16 * 2);  // entries of 64 cells, doubled
}

}  // namespace
}  // namespace pelt::rivals
