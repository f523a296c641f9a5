/// Figures 2 and 3 of Kavan & Zara 2005 with their numbers.

#include "figures.hpp"

#include "figure_drawings.hpp"
#include "paper/on_demand.hpp"
#include "posed_mesh.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace pelt::paper {
namespace {

using test::Ball;
using test::Figure2;
using test::Figure3;
using test::Vec3d;

constexpr double kTolerance = 1e-12;

/// 360 directions in the plane.
std::vector<Vec3d> directions() {
  std::vector<Vec3d> all;
  for (int degrees = 0; degrees < 360; ++degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    all.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return all;
}

/// Length of the boundary, by Cauchy's formula: the mean width times pi.
double perimeter(const std::vector<Ball>& balls) {
  double width = 0;
  for (const Vec3d& m : directions())
    width += test::hull_support(balls, m) + test::hull_support(balls, Vec3d() - m);
  return 3.14159265358979323846 * width / 360;
}

TEST(Figure2, WeightsGiveTheIntervalsOfTheText) {
  for (const WeightInterval& interval : Figure2().intervals()) {
    EXPECT_EQ(interval.low, 0.4);
    EXPECT_EQ(interval.high, 0.6);
  }
  ASSERT_EQ(Figure2().corners().size(), 2u);
}

TEST(Figure2, BV1EnclosesTheLinesOfAllWeightsAndBV2ThoseOfTheIntervals) {
  const Figure2 figure;
  const auto bv1 = figure.images_of_sphere(), bv2 = figure.corners();
  for (const Vec3d& m : directions())
    for (std::size_t i = 0; i < 3; ++i) {
      for (int step = 0; step <= 20; ++step) {
        const double w = step / 20.0;
        EXPECT_LE(dot(m, figure.blended(i, w)), test::hull_support(bv1, m) + kTolerance);
        if (step >= 8 && step <= 12) {  // w within <0.4, 0.6>
          EXPECT_LE(dot(m, figure.blended(i, w)), test::hull_support(bv2, m) + kTolerance);
        }
      }
      EXPECT_LE(dot(m, figure.posed(i)), test::hull_support(bv2, m) + kTolerance);
    }
}

TEST(Figure2, BV2LiesInsideBV1AndIsHalfAsLarge) {
  const Figure2 figure;
  const auto bv1 = figure.images_of_sphere(), bv2 = figure.corners();
  for (const Vec3d& m : directions())
    EXPECT_LE(test::hull_support(bv2, m), test::hull_support(bv1, m) + kTolerance);
  // Circles of radius 1 around ends 3 apart, and 0.6 apart.
  EXPECT_NEAR(test::length(bv1[0].centre - bv1[1].centre), 3, kTolerance);
  EXPECT_NEAR(test::length(bv2[0].centre - bv2[1].centre), 0.6, kTolerance);
  EXPECT_NEAR(perimeter(bv1), 2 * 3.14159265 + 6, 1e-3);
  EXPECT_NEAR(perimeter(bv2), 2 * 3.14159265 + 1.2, 1e-3);
}

test::Shape shape_of(const Figure2& figure) {
  test::Shape shape;
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = 2;
  shape.joint_count = 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& v = figure.vertices[i];
    shape.rest_positions.push_back({static_cast<float>(v.x), static_cast<float>(v.y), 0});
    for (std::size_t j = 0; j < 2; ++j) {
      shape.joints.push_back(static_cast<std::uint16_t>(j));
      shape.weights.push_back(static_cast<float>(figure.weights[i][j]));
    }
  }
  return shape;
}

std::vector<Matrix4> palette_of(const Figure2& figure) {
  std::vector<Matrix4> palette;
  for (const test::PlaneRotation& joint : figure.joints) {
    const Vec3d at = joint({0, 0, 0});
    const auto c = static_cast<float>(joint.cosine), s = static_cast<float>(joint.sine);
    palette.push_back({{c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, static_cast<float>(at.x),
                        static_cast<float>(at.y), 0, 1}});
  }
  return palette;
}

TEST(Figure2, TheSystemRefitsItsSphereToTheRadiiOfTheDrawing) {
  const Figure2 figure;
  const SkinnedMesh mesh = test::checked_mesh(shape_of(figure));
  const Palette palette = test::checked_palette(mesh, palette_of(figure));
  const auto refitted = [&](BoundKind kind) {
    const SphereModel model = build_sphere_model(mesh, kind);
    EXPECT_NEAR(model.tree.nodes[0].rest.radius, 1, 1e-6);
    return Refit(model, 2).sphere(0, palette);
  };
  for (const auto& [kind, radius] :
       {std::pair{BoundKind::plain, 2.5}, std::pair{BoundKind::optimised, 1.3}}) {
    const Float4 sphere = refitted(kind);
    EXPECT_NEAR(sphere[0], 0, 1e-5);
    EXPECT_NEAR(sphere[1], -0.5, 1e-5);
    EXPECT_NEAR(sphere[3], radius, 1e-4);
    for (std::uint32_t v = 0; v < 3; ++v) {
      const Vec3 posed = detail::posed_vertex(mesh, palette, v);
      EXPECT_NEAR(test::length(Vec3d(posed) - figure.posed(v)), 0, 1e-6);
      EXPECT_LE(test::relative_reach(sphere, posed), 1);
    }
  }
}

TEST(Figure3, HasFourCorners) {
  std::vector<double> corners;
  append_weight_corners(Figure3().intervals, corners);
  ASSERT_EQ(corners.size(), 12u);
  std::vector<std::array<double, 3>> found;
  for (std::size_t c = 0; c < 12; c += 3)
    found.push_back({corners[c], corners[c + 1], corners[c + 2]});
  std::sort(found.begin(), found.end());
  const std::array<double, 3> expected[] = {{0, 0, 1}, {0, 1, 0}, {0.6, 0, 0.4}, {0.6, 0.4, 0}};
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[c][j], expected[c][j], kTolerance);
}

TEST(Figure3, TheHullOfTheCornerSpheresIsTheGeneralisedHullAndCutsOffTheFirstSphere) {
  const Figure3 figure;
  const std::vector<Ball> corners = figure.corners();
  for (const Vec3d& m : directions()) {
    EXPECT_NEAR(test::hull_support(corners, m),
                test::generalised_hull_support(figure.intervals, figure.spheres, m), kTolerance);
    EXPECT_LE(test::hull_support(corners, m), test::hull_support(figure.spheres, m) + kTolerance);
  }
  // Upwards CH_1 reaches to S_1, CH_2 six tenths of the way from S_2 and S_3: 0.6 * 4 - 1 + 1.
  EXPECT_NEAR(test::hull_support(figure.spheres, {0, 1, 0}), 4, kTolerance);
  EXPECT_NEAR(test::hull_support(corners, {0, 1, 0}), 2.4, kTolerance);
  EXPECT_NEAR(test::hull_support(corners, {0, -1, 0}), 2, kTolerance);
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Figures, OfTheDocumentationAreDrawnFromTheseNumbers) {
  const std::string folder = PELT_SOURCE_DIR "/docs/figures/";
  EXPECT_EQ(text_of(folder + "figure2.svg"), test::draw_figure2()) << "run draw_figures " << folder;
  EXPECT_EQ(text_of(folder + "figure3.svg"), test::draw_figure3()) << "run draw_figures " << folder;
}

}  // namespace
}  // namespace pelt::paper
