#include "model/bound_fit.hpp"
#include "base/vec3.hpp"
#include "model/intervals.hpp"
#include "model/unpack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

namespace pelt::detail {
namespace {

/// A symmetric 3 x 3 matrix.
struct Symmetric3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  void add_square(const Vec3d& v) {
    xx += v.x * v.x, yy += v.y * v.y, zz += v.z * v.z;
    xy += v.x * v.y, xz += v.x * v.z, yz += v.y * v.z;
  }
};

/// One rotation of Jacobi's method (Golub & Van Loan, Matrix Computations, 8.5): makes m[p][q] zero
/// and rotates the axes p and q in the same way.
void rotate(double (&m)[3][3], std::array<Vec3d, 3>& axes, int p, int q) {
  if (m[p][q] == 0) return;
  const double slope = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (slope >= 0 ? 1 : -1) / (std::fabs(slope) + std::sqrt(1 + slope * slope));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double kp = m[k][p], kq = m[k][q];
    m[k][p] = c * kp - s * kq, m[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    const double pk = m[p][k], qk = m[q][k];
    m[p][k] = c * pk - s * qk, m[q][k] = s * pk + c * qk;
  }
  const Vec3d axis_p = c * axes[p] - s * axes[q];
  axes[q] = s * axes[p] + c * axes[q];
  axes[p] = axis_p;
}

/// Eigenvectors: three unit vectors, orthogonal up to rounding of double.
std::array<Vec3d, 3> eigenvectors(const Symmetric3& a) {
  double m[3][3] = {{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}};
  std::array<Vec3d, 3> axes = {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  constexpr int kSweeps = 8;  // quadratic convergence: four reach the precision of double
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  return axes;
}

/// The x with (matrix) x = b. Precondition: positive definite.
Vec3d solve(const Symmetric3& a, const Vec3d& b) {
  const Vec3d x{a.xx, a.xy, a.xz}, y{a.xy, a.yy, a.yz}, z{a.xz, a.yz, a.zz};
  const Vec3d yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  return (1 / dot(x, yz)) * (b.x * yz + b.y * zx + b.z * xy);
}

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

DisplacementFit::DisplacementFit(const Tree& tree)
    : vertices_(unpack_vertices(tree)), numbers_(tree.joint_count) {}

void DisplacementFit::add(const NodeBounds& bounds, const NodeBound& bound,
                          std::span<const std::uint32_t> places) {
  joint_boxes_.resize(bounds.joint_boxes.size());
  shapes_.resize(bounds.shapes.size());
  displaced_.clear();
  vertex_counts_.assign(bound.is_affine() ? 1 : bound.joint_count, 0);
  if (bound.is_affine()) {
    for (const std::uint32_t place : places) gather(0, place);
    box_all(shapes_, bound.shape);
    return;
  }
  for (std::uint32_t i = 0; i < bound.joint_count; ++i)
    numbers_[bounds.joints[bound.first_joint + i]] = i;
  for (const std::uint32_t place : places)
    for (const Influence& influence : vertices_.influences_of(place))
      gather(numbers_[influence.joint], place);
  box_all(joint_boxes_, bound.first_record);
}

void DisplacementFit::gather(std::uint32_t body, std::uint32_t place) {
  ++vertex_counts_[body];
  for (const Displacement& displacement : vertices_.displacements_of(place))
    displaced_.push_back({body, displacement});
}

/// `first` is the number of the set's first body among all bodies of its kind.
void DisplacementFit::box_all(std::vector<Boxes>& bodies, std::size_t first) {
  const auto key = [](const Displaced& d) { return std::tuple(d.body, d.displacement.target); };
  std::sort(displaced_.begin(), displaced_.end(),
            [&](const Displaced& a, const Displaced& b) { return key(a) < key(b); });
  for (auto run = displaced_.begin(); run != displaced_.end();) {
    const auto end = std::find_if(run, displaced_.end(),
                                  [&](const Displaced& other) { return key(other) != key(*run); });
    bodies[first + run->body].push_back(box_of({&*run, static_cast<std::size_t>(end - run)}));
    run = end;
  }
}

DisplacementBox DisplacementFit::box_of(std::span<const Displaced> of_one_target) const {
  Intervals3 extents;
  for (const Displaced& displaced : of_one_target)
    extents.include(Vec3d(displaced.displacement.by));
  const bool some_stay = of_one_target.size() < vertex_counts_[of_one_target[0].body];
  if (some_stay) extents.include(Vec3d());
  DisplacementBox box;
  box.target = of_one_target[0].displacement.target;
  extents.store(box.centre, box.half);
  return box;
}

void DisplacementFit::finish(NodeBounds& bounds) const {
  bounds.displacement_begin.reserve(joint_boxes_.size() + shapes_.size() + 1);
  bounds.displacement_begin.push_back(0);
  for (const auto* bodies : {&joint_boxes_, &shapes_})
    for (const Boxes& boxes : *bodies) {
      bounds.displacements.insert(bounds.displacements.end(), boxes.begin(), boxes.end());
      bounds.displacement_begin.push_back(static_cast<std::uint32_t>(bounds.displacements.size()));
    }
  bounds.displacements.shrink_to_fit();
}

}  // namespace pelt::detail
