#include "evaluation/programs/query_stage.hpp"

#include "evaluation/programs/program.hpp"

#include <pelt/bounds.hpp>

#include <cmath>

namespace pelt::programs {
namespace {

Box box_of(Pose& pose, const JointPalette& palette) {
  (void)pose.set_palette(palette);
  Bounds found;
  exact_bounds(pose, found);
  return found.box;
}

JointPalette moved(JointPalette palette, double x) {
  for (Matrix4& m : palette) m.m[12] = static_cast<float>(double{m.m[12]} + x);
  return palette;
}

/// Two instances side by side along x.
class Neighbours {
 public:
  explicit Neighbours(const SkinnedModel& model) : a_(model), b_(model) {}

  /// How far `b` has to be moved to be about `gap` from `a`. Moving `b` by less than its excess
  /// distance cannot bring it too near.
  double shift_to(const JointPalette& a, const JointPalette& b, double gap) {
    const Box box_a = box_of(a_, a), box_b = box_of(b_, b);
    double shift = double{box_a.high.x} - double{box_b.low.x} + 2 * gap;
    for (int step = 0; step < 100; ++step) {
      (void)b_.set_palette(moved(b, shift));
      Distance closest;
      distance(a_, b_, scratch_, closest);
      if (closest.distance < 1.05 * gap) break;
      shift -= closest.distance - gap;
    }
    return shift;
  }

 private:
  Pose a_, b_;
  Scratch scratch_;
};

std::vector<Vec3> points_around(const Box& box, std::uint32_t count, Numbers& numbers) {
  std::vector<Vec3> points(count);
  const auto between = [&](float low, float high) {
    return static_cast<float>(double{low} + (double{high} - low) * numbers.between(-0.3, 1.3));
  };
  for (Vec3& p : points)
    p = {between(box.low.x, box.high.x), between(box.low.y, box.high.y),
         between(box.low.z, box.high.z)};
  return points;
}

}  // namespace

QueryStage::QueryStage(const asset::Asset& asset, const SkinnedModel& model, std::uint32_t frames,
                       std::uint32_t points) {
  asset::SampleScratch sampling;
  const auto sample = [&](const asset::Clip* clip, double share) {
    JointPalette palette(model.joint_count());
    const double seconds = clip ? clip->duration * std::fmod(share, 1.0) : 0;
    sample_palette(asset, clip, static_cast<float>(seconds), {}, sampling, palette);
    return palette;
  };
  Pose pose(model);
  const Box box = box_of(pose, sample(nullptr, 0));
  metre_ = (double{box.high.y} - double{box.low.y}) / 1.75;
  foot_ = {(box.low.x + box.high.x) / 2, box.low.y, (box.low.z + box.high.z) / 2};

  const asset::Clip* clip = asset.clips.empty() ? nullptr : asset.clips.data();
  Neighbours neighbours(model);
  Numbers numbers(11);
  for (std::uint32_t i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / frames;
    const JointPalette a = sample(clip, share), b = sample(clip, share + 0.35);
    const double near = neighbours.shift_to(a, b, 0.03 * metre_);
    frames_.push_back({a, moved(b, near - 0.1 * metre_), moved(b, near), moved(b, near + metre_),
                       points_around(box_of(pose, a), points, numbers)});
  }
}

HeightField QueryStage::hills(std::uint32_t side) const {
  const double spacing = 0.1 * metre_, first = -spacing * (side / 2);
  std::vector<float> heights(std::size_t{side} * side);
  for (std::uint32_t row = 0; row < side; ++row)
    for (std::uint32_t column = 0; column < side; ++column) {
      const double x = 0.1 * (column - side / 2.0), z = 0.1 * (row - side / 2.0);
      heights[std::size_t{row} * side + column] =
          static_cast<float>(metre_ * (0.03 + 0.2 * std::sin(0.7 * x) * std::sin(0.4 * z)));
    }
  const Vec3 origin = {static_cast<float>(double{foot_.x} + first), foot_.y,
                       static_cast<float>(double{foot_.z} + first)};
  const auto step = static_cast<float>(spacing);
  return *build_height_field({heights, side, side, origin, step, step});
}

SkinnedModel as_static_mesh(const HeightField& field) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3& corner : field.triangle(t)) positions.push_back(corner);
    triangles.push_back({first, first + 1, first + 2});
  }
  const std::vector<std::uint16_t> joints(positions.size(), 0);
  const std::vector<float> weights(positions.size(), 1);
  return *build_model({positions, triangles, 1, joints, weights, 1});
}

}  // namespace pelt::programs
