#include "model/bound_fit.hpp"

#include "model/intervals.hpp"
#include "model/symmetric3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt::detail {
namespace {

constexpr double kUnit = 0x1p-24;  // u of the rounding analysis

/// Limits of the slopes, and of the sum of the mean weights. Beyond them the vertices of the node
/// nearly coincide and do not determine a slope, and the affine bound is not used.
constexpr double kMaxSlope = 0x1p40, kMaxMeans = 32;

Vec3d to_vec3d(const float* v) { return Vec3d(Vec3{v[0], v[1], v[2]}); }

Vec3d magnitude(const Vec3d& v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

void store(const Vec3d& v, float* out) {
  const Vec3 rounded = to_float(v);
  out[0] = rounded.x, out[1] = rounded.y, out[2] = rounded.z;
}

/// Fits the box along the principal axes of the offsets. The box is enlarged by a millionth of its
/// extents, which is far above the rounding of the axes.
void fit_axes(std::span<const Vec3d> offsets, RestShape& shape) {
  Symmetric3 squares;
  for (const Vec3d& x : offsets) squares.add_square(x);
  const std::array<Vec3d, 3> axes = eigenvectors(squares);
  Intervals3 along;
  for (const Vec3d& x : offsets) along.include({dot(axes[0], x), dot(axes[1], x), dot(axes[2], x)});
  const Vec3d middle = along.middle();
  store(middle.x * axes[0] + middle.y * axes[1] + middle.z * axes[2], shape.axes_centre);
  const double slack = 1e-6 * std::sqrt(squared_length(to_vec3d(shape.half)));
  store((along.x.reach(middle.x) + slack) * axes[0], shape.axes[0]);
  store((along.y.reach(middle.y) + slack) * axes[1], shape.axes[1]);
  store((along.z.reach(middle.z) + slack) * axes[2], shape.axes[2]);
}

/// Least squares fit of each weight as an affine function of x over the vertices of a node. The
/// slope is damped across a flat patch, where the vertices hardly determine it.
class WeightFit {
 public:
  WeightFit(const NodeVertices& vertices, std::span<const Vec3d> offsets)
      : mean_(vertices.joints().size()), gradient_(vertices.joints().size()) {
    const double share = 1 / static_cast<double>(offsets.size());
    for (const Vec3d& x : offsets) centroid_ = centroid_ + share * x;
    for (const Vec3d& x : offsets) spread_.add_square(x - centroid_);
    const double damping = 1e-4 * (spread_.xx + spread_.yy + spread_.zz) + 1e-300;
    spread_.xx += damping, spread_.yy += damping, spread_.zz += damping;
    std::vector<Vec3d> covariance(mean_.size());
    for (std::size_t k = 0; k < offsets.size(); ++k)
      vertices.each_weight(vertices.places()[k], [&](std::uint32_t i, double weight) {
        mean_[i] += share * weight;
        covariance[i] = covariance[i] + weight * (offsets[k] - centroid_);
      });
    for (std::size_t i = 0; i < covariance.size(); ++i)
      gradient_[i] = solve(spread_, covariance[i]);
    if (!is_tame()) std::fill(gradient_.begin(), gradient_.end(), Vec3d());
  }

  /// Stores the slope and the value at x = 0 of the weight of joint i.
  void store_line(std::size_t i, JointFit& fit) const {
    store(gradient_[i], fit.line);
    fit.line[3] = static_cast<float>(value_at_centre(i));
  }

 private:
  double value_at_centre(std::size_t i) const { return mean_[i] - dot(gradient_[i], centroid_); }

  /// Whether all slopes and values are within the limits. Slopes are NaN if vertices coincide.
  bool is_tame() const {
    double values = 0, steepest = 0;
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      const Vec3d slope = magnitude(gradient_[i]);
      values += std::fabs(value_at_centre(i));  // NaN if a slope is NaN
      steepest = std::max({steepest, slope.x, slope.y, slope.z});
    }
    return values <= kMaxMeans && steepest <= kMaxSlope;
  }

  Vec3d centroid_;
  Symmetric3 spread_;
  std::vector<double> mean_;
  std::vector<Vec3d> gradient_;
};

/// Residual of one joint's weights: what the affine function does not explain.
struct Residual {
  Interval rest;              // of r_j
  Intervals3 moment;          // of (w_j - m_j) x
  double largest_offset = 0;  // of |w_j - m_j|

  void include(const JointFit& fit, double weight, const Vec3d& x) {
    const double offset = weight - static_cast<double>(fit.mean());
    rest.include(offset - dot(to_vec3d(fit.line), x));
    moment.include(offset * x);
    largest_offset = std::max(largest_offset, std::fabs(offset));
  }
};

std::vector<Residual> residuals(const NodeVertices& vertices, std::span<const Vec3d> offsets,
                                std::span<const JointFit> fits) {
  std::vector<Residual> found(fits.size());
  std::vector<double> weights(fits.size());
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    std::fill(weights.begin(), weights.end(), 0.0);
    vertices.each_weight(vertices.places()[k],
                         [&](std::uint32_t i, double weight) { weights[i] = weight; });
    for (std::size_t i = 0; i < fits.size(); ++i) found[i].include(fits[i], weights[i], offsets[k]);
  }
  return found;
}

/// Largest distance of the two boxes of a rest shape from its centre, on each axis.
Vec3d reach(const RestShape& shape) {
  Vec3d along_axes = magnitude(to_vec3d(shape.axes_centre));
  for (const auto& axis : shape.axes) along_axes = along_axes + magnitude(to_vec3d(axis));
  const Vec3d half = to_vec3d(shape.half);
  return {std::max(half.x, along_axes.x), std::max(half.y, along_axes.y),
          std::max(half.z, along_axes.z)};
}

/// Makes the joint with the largest residual the reference.
void take_reference(AffineFit& fit, std::vector<Residual>& left) {
  const auto reference = std::max_element(fit.fits.begin(), fit.fits.end(),
                                          [](const JointFit& a, const JointFit& b) {
                                            return a.residual() < b.residual();
                                          }) -
                         fit.fits.begin();
  std::rotate(fit.joints.begin(), fit.joints.begin() + reference,
              fit.joints.begin() + reference + 1);
  fit.fits.erase(fit.fits.begin() + reference);
  left.erase(left.begin() + reference);
}

/// Factor for terms of second order.
constexpr double kSecondOrder = 1 + 0x1p-6;

/// The margin of node_bounds.hpp.
float affine_margin(const AffineFit& fit, std::span<const Residual> left,
                    const WeightRounding& rounding) {
  const Vec3d y = reach(fit.shape);
  double means = 0, terms = 0;
  for (std::size_t i = 0; i < fit.fits.size(); ++i) {
    const JointFit& joint = fit.fits[i];
    means += std::fabs(static_cast<double>(joint.mean()));
    terms += dot(magnitude(to_vec3d(joint.line)), y) + static_cast<double>(joint.residual()) +
             left[i].largest_offset;
  }
  const double n = static_cast<double>(fit.joints.size());
  const double stretch = std::max(1.0, (y.x + y.y + y.z) / rounding.rest_extent);
  return rounded_up(kSecondOrder *
                    ((rounding.influences + 5) * kUnit + rounding.sum_error +
                     (2 * n + 20) * kUnit * (stretch * (1 + 2 * means) + 2 * terms)));
}

/// Fits the rest shape, and writes the offsets of the vertices from its centre.
RestShape fit_shape(const NodeVertices& vertices, std::vector<Vec3d>& offsets) {
  RestShape shape;
  Intervals3 box;
  for (const std::uint32_t place : vertices.places()) box.include(vertices.position(place));
  box.store(shape.centre, shape.half);
  offsets.reserve(vertices.places().size());
  for (const std::uint32_t place : vertices.places())
    offsets.push_back(vertices.position(place) - to_vec3d(shape.centre));
  fit_axes(offsets, shape);
  return shape;
}

}  // namespace

WeightRounding weight_rounding(const Tree& tree) {
  WeightRounding rounding;
  rounding.rest_extent = static_cast<double>(tree.rest_extent);
  for (std::size_t v = 0; v < tree.rest_positions.size(); ++v) {
    const std::uint32_t begin = tree.influence_begin[v], end = tree.influence_begin[v + 1];
    double sum = 0;
    for (std::uint32_t i = begin; i < end; ++i) sum += static_cast<double>(tree.weights[i]);
    rounding.influences = std::max(rounding.influences, static_cast<double>(end - begin));
    rounding.sum_error = std::max(rounding.sum_error, std::fabs(sum - 1));
  }
  return rounding;
}

JointBoxesFit fit_joint_boxes(const NodeVertices& vertices, const WeightRounding& rounding) {
  std::vector<Intervals3> extents(vertices.joints().size());
  for (const std::uint32_t place : vertices.places())
    vertices.each_weight(
        place, [&](std::uint32_t i, double) { extents[i].include(vertices.position(place)); });
  JointBoxesFit fit;
  fit.boxes.resize(extents.size());
  for (std::size_t i = 0; i < extents.size(); ++i)
    extents[i].store(fit.boxes[i].centre, fit.boxes[i].half);
  fit.margin = rounded_up(kSecondOrder * ((rounding.influences + 12) * kUnit + rounding.sum_error));
  return fit;
}

AffineFit fit_affine(const NodeVertices& vertices, const WeightRounding& rounding) {
  AffineFit fit;
  std::vector<Vec3d> offsets;
  fit.shape = fit_shape(vertices, offsets);
  fit.joints.assign(vertices.joints().begin(), vertices.joints().end());
  fit.fits.resize(fit.joints.size(), JointFit{});
  const WeightFit lines(vertices, offsets);
  for (std::size_t i = 0; i < fit.fits.size(); ++i) lines.store_line(i, fit.fits[i]);

  std::vector<Residual> left = residuals(vertices, offsets, fit.fits);
  for (std::size_t i = 0; i < left.size(); ++i) {
    fit.fits[i].spread[3] = rounded_up(left[i].rest.reach(0));
    left[i].moment.store(fit.fits[i].shift, fit.fits[i].spread);
  }
  take_reference(fit, left);
  fit.margin = affine_margin(fit, left, rounding);
  return fit;
}

}  // namespace pelt::detail
