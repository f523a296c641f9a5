#include "scenes/smooth_normals.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace pelt::scenes {
namespace {

/// A roof: two faces with the ridge 1-2. The second face is twice as large and has copies of the
/// ridge's vertices, 4 and 5. Also a vertex that no triangle uses, and a collapsed triangle.
const std::vector<Vec3> kRoof = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, -2},
                                 {0, 0, 0},  {0, 1, 0}, {7, 7, 7}, {5, 5, 5}};
const std::vector<Triangle> kFaces = {{0, 1, 2}, {4, 3, 5}, {7, 7, 7}};

std::vector<Vec3> normals_of_roof(const std::vector<std::uint32_t>& seams) {
  std::vector<Vec3> normals(kRoof.size());
  smooth_normals(kRoof, kFaces, seams, normals);
  return normals;
}

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-6);
  EXPECT_NEAR(found.y, expected.y, 1e-6);
  EXPECT_NEAR(found.z, expected.z, 1e-6);
}

TEST(SmoothNormals, AreThoseOfTheTrianglesWhereNothingIsShared) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 4, 5, 6, 7});
  for (const int v : {0, 1, 2}) expect_near(normals[v], {0, 0, 1});
  for (const int v : {3, 4, 5}) expect_near(normals[v], {1, 0, 0});
}

TEST(SmoothNormals, AreWeightedByAreaAcrossASeam) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 1, 2, 6, 7});
  const float root = std::sqrt(5.0f);
  for (const int v : {1, 2, 4, 5}) expect_near(normals[v], {2 / root, 0, 1 / root});
  expect_near(normals[0], {0, 0, 1});
  expect_near(normals[3], {1, 0, 0});
}

TEST(SmoothNormals, PointUpWhereThereIsNothingToGoBy) {
  const std::vector<Vec3> normals = normals_of_roof({0, 1, 2, 3, 4, 5, 6, 7});
  expect_near(normals[6], {0, 1, 0});
  expect_near(normals[7], {0, 1, 0});
}

}  // namespace
}  // namespace pelt::scenes
