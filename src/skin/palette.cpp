#include "skin/palette.hpp"

#include <pelt/math.hpp>

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "base/problem.hpp"
#include "base/vec3.hpp"
#include "skin/dual_skin.hpp"
#include "skin/palette_lanes.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

namespace pelt::detail {

MorphWeights::MorphWeights(std::span<const float> extents)
    : extents_(extents.begin(), extents.end()), weights_(extents.size()) {
  active_.reserve(extents.size());
}

Problem MorphWeights::check(std::span<const float> weights) const {
  if (weights.size() != count())
    return problem("morph_weights has %zu elements, expected %zu: one for each morph target",
                   weights.size(), count());
  for (std::size_t m = 0; m < weights.size(); ++m)
    if (!std::isfinite(weights[m]))
      return problem("morph_weights[%zu] is %g", m, static_cast<double>(weights[m]));
  if (extent_of(weights) <= static_cast<double>(kMaxCoordinate)) return {};
  std::size_t farthest = 0;
  for (std::size_t m = 0; m < weights.size(); ++m)
    if (std::fabs(weights[m]) * extents_[m] > std::fabs(weights[farthest]) * extents_[farthest])
      farthest = m;
  return problem("morph_weights[%zu] of %g, with the others, can displace a vertex by 2^60 units",
                 farthest, static_cast<double>(weights[farthest]));
}

void MorphWeights::set(std::span<const float> weights) {
  std::copy(weights.begin(), weights.end(), weights_.begin());
  active_.clear();
  for (std::uint32_t m = 0; m < weights.size(); ++m)
    if (weights[m] != 0) active_.push_back(m);
}

double MorphWeights::extent_of(std::span<const float> weights) const {
  double sum = 0;
  for (std::size_t m = 0; m < weights.size(); ++m)
    sum += std::fabs(static_cast<double>(weights[m])) * static_cast<double>(extents_[m]);
  return sum;
}

std::size_t MorphWeights::memory_bytes() const { return bytes_held(extents_, weights_, active_); }

namespace {

// Converts joint matrices from the forms of the interface to Pelt's own.

/// Transposes, and adds the last row.
inline Matrix4 to_matrix(const Matrix3x4& rows) {
  Matrix4 matrix;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      matrix.m[4 * column + row] = rows.m[4 * row + column];
  return matrix;
}

/// Rounds each element to the nearest float; elements beyond the largest float become infinite.
inline Matrix4 to_matrix(std::span<const double, 16> numbers) {
  Matrix4 matrix;
  for (std::size_t i = 0; i < 16; ++i) matrix.m[i] = static_cast<float>(numbers[i]);
  return matrix;
}

static_assert(kMaxExtent == 4 * kMaxCoordinate);

/// Lower limit of the size of linear parts. Underflow in products with them is then far below the
/// rounding of M.
constexpr double kLeastLinear = 0x1p-100;

bool has_affine_last_row(const float* m) {
  return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
}

/// Describes what is wrong with the matrix of a joint.
Problem describe(const float* m, std::size_t joint) {
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(m[i]))
      return problem("palette[%zu] has the element %g at row %d, column %d", joint,
                     static_cast<double>(m[i]), i % 4, i / 4);
  if (!has_affine_last_row(m))
    return problem(
        "palette[%zu] has the last row %g %g %g %g, expected 0 0 0 1 (is the matrix row-major?)",
        joint, static_cast<double>(m[3]), static_cast<double>(m[7]), static_cast<double>(m[11]),
        static_cast<double>(m[15]));
  return problem("palette[%zu] can move a vertex beyond 2^60 units", joint);
}

void negate(DualQuaternion& q) {
  for (float& number : q.real) number = -number;
  for (float& number : q.dual) number = -number;
}

void include(const PaletteScan& scan, PaletteScan& all) {
  all.linear = std::max(all.linear, scan.linear);
  all.translation = std::max(all.translation, scan.translation);
}

}  // namespace

Problem find_not_rigid(const float* matrix, std::size_t joint) {
  const auto axis = [&](std::size_t column) {
    const float* const m = matrix + 4 * column;
    return Vec3d(Vec3{m[0], m[1], m[2]});
  };
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = row; column < 3; ++column) {
      const double error = dot(axis(row), axis(column)) - (row == column ? 1 : 0);
      if (!(std::fabs(error) <= kRigidTolerance))
        return problem(
            "palette[%zu] is not rigid: A^T A - I has %g at row %zu, column %zu, expected 0 (dual "
            "quaternion skinning needs joints without scale and shear)",
            joint, error, row, column);
    }
  if (dot(cross(axis(0), axis(1)), axis(2)) < 0)
    return problem("palette[%zu] mirrors, but dual quaternion skinning needs rigid joints", joint);
  return {};
}

Problem find_not_unit(const float* dual, std::size_t joint) {
  for (int i = 0; i < 8; ++i)
    if (!std::isfinite(dual[i]))
      return problem("dual_quaternions[%zu] has the element %g at %d", joint,
                     static_cast<double>(dual[i]), i);
  const Vec3d r(dual[0], dual[1], dual[2]);
  const double w = dual[3], square = squared_length(r) + w * w;
  if (std::fabs(square - 1) <= kRigidTolerance) return {};
  return problem("dual_quaternions[%zu] has a real part of squared length %g, expected 1", joint,
                 square);
}

Palette::Palette(std::uint32_t joint_count, float rest_extent, std::span<const float> morph_extents,
                 std::uint32_t dual_influences, std::span<const JointLink> links)
    : joints_(joint_count),
      duals_(dual_influences > 0 ? joint_count : 0),
      morphs_(morph_extents),
      dual_influences_(dual_influences),
      rest_extent_(std::max(rest_extent, kLeastRestExtent)),
      reach_(double{rest_extent_}),
      extent_(extent_of(scan_, reach_)),
      links_(links.begin(), links.end()),
      aligned_with_(duals_.size()),
      link_motions_(links.size()),
      next_joints_(duals_.size()),
      next_duals_(duals_.size()) {
  PELT_ASSERT(extent_ <= kMaxExtent);
  for (const JointLink& link : links_)
    if (aligned_with_[link.second] == 0) aligned_with_[link.second] = link.first;
}

/// The problem of the first joint that has one.
template <typename ProblemOf>
Problem Palette::first_problem(const ProblemOf& problem_of) const {
  for (std::size_t joint = 0; joint < joints_.size(); ++joint)
    if (Problem found = problem_of(joint); !found.empty()) return found;
  return {};
}

Result<void> Palette::set(const JointMatrices& matrices) {
  return std::visit([this](const auto& form) { return set_form(form); }, matrices);
}

Result<void> Palette::set_form(std::span<const Matrix4> matrices) {
  return set_form(floats_of(matrices));
}

Result<void> Palette::set_form(std::span<const float> floats) {
  if (floats.size() != joints_.size() * 16)
    return invalid_argument(
        problem("the palette has %zu floats, expected %zu: 16 for each of the model's %zu joints",
                floats.size(), 16 * joints_.size(), joints_.size()));
  if (is_dual()) return set_rigid(floats.data());
  const PaletteScan scan = scan_palette(floats.data(), joints_.size());
  if (!are_good(scan, reach_))
    if (Problem found = find_bad_joint(floats, reach_); !found.empty())
      return invalid_argument(std::move(found));
  std::memcpy(joints_.data()->m.data(), floats.data(), floats.size_bytes());
  keep(scan);
  return {};
}

/// See `to_matrix`.
Result<void> Palette::set_form(std::span<const Matrix3x4> matrices) {
  if (matrices.size() != joints_.size())
    return invalid_argument(
        problem("the palette has %zu matrices, expected %zu: one for each joint", matrices.size(),
                joints_.size()));
  return set_by([&](std::size_t joint) { return to_matrix(matrices[joint]); });
}

Result<void> Palette::set_form(std::span<const double> numbers) {
  if (numbers.size() != joints_.size() * 16)
    return invalid_argument(
        problem("the palette has %zu doubles, expected %zu: 16 for each of the model's %zu joints",
                numbers.size(), 16 * joints_.size(), joints_.size()));
  return set_by(
      [&](std::size_t joint) { return to_matrix(numbers.subspan(16 * joint).first<16>()); });
}

/// Converts twice, first to validate all joints and then to store them: an error must leave the
/// palette unchanged, and the function must not allocate.
template <typename MatrixOf>
Result<void> Palette::set_by(const MatrixOf& matrix_of) {
  if (is_dual()) {
    for (std::size_t j = 0; j < joints_.size(); ++j) next_joints_[j] = matrix_of(j);
    return set_rigid(floats_of(next_joints_).data());
  }
  PaletteScan all;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Matrix4 matrix = matrix_of(j);
    const PaletteScan scan = scan_palette(matrix.m.data(), 1);
    if (!are_good(scan, reach_)) return invalid_argument(describe(matrix.m.data(), j));
    include(scan, all);
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j] = matrix_of(j);
  keep(all);
  return {};
}

Result<void> Palette::set_dual_quaternions(std::span<const float> floats) {
  if (!is_dual())
    return invalid_argument(
        problem("the model has linear blend skinning: build it with ModelOptions::skinning = "
                "Skinning::dual_quaternion, or call set_palette"));
  if (floats.size() != duals_.size() * 8)
    return invalid_argument(
        problem("there are %zu floats, expected %zu: 8 for each of the model's %zu joints",
                floats.size(), 8 * duals_.size(), duals_.size()));
  if (!normalise_duals(floats.data(), duals_.size(), next_duals_.data()))
    return invalid_argument(
        first_problem([&](std::size_t joint) { return find_not_unit(&floats[8 * joint], joint); }));
  return take_next_duals();
}

/// `matrices` may be next_joints_.
Result<void> Palette::set_rigid(const float* matrices) {
  if (!scan_palette(matrices, duals_.size()).is_affine ||
      !find_rigid_motions(matrices, duals_.size(), next_duals_.data()))
    return invalid_argument(first_problem([&](std::size_t joint) {
      const float* const matrix = matrices + 16 * joint;
      return scan_palette(matrix, 1).is_affine ? find_not_rigid(matrix, joint)
                                               : describe(matrix, joint);
    }));
  return take_next_duals();
}

/// Makes the next dual quaternions the current ones, unless they move vertices too far.
Result<void> Palette::take_next_duals() {
  align_next_duals();
  const PaletteScan scan = {
      .linear = 1,
      .translation = find_matrices(next_duals_.data(), next_duals_.size(), next_joints_.data())};
  if (!are_good(scan, reach_))
    if (Problem found = find_bad_joint(floats_of(next_joints_), reach_); !found.empty())
      return invalid_argument(std::move(found));
  std::swap(duals_, next_duals_);
  std::swap(joints_, next_joints_);
  keep(scan);
  return {};
}

/// A motion has two dual quaternions, q and -q. Takes the one closer to that of a linked joint, so
/// that negates_none is true for most poses.
void Palette::align_next_duals() {
  for (std::size_t j = 0; j < next_duals_.size(); ++j) {
    const DualQuaternion& linked = next_duals_[aligned_with_[j]];
    if (dot(dual_of(linked), dual_of(next_duals_[j])) < 0) negate(next_duals_[j]);
  }
}

/// M of the scanned joints, rounded up. Not finite if an element is not finite or nearly overflows.
float Palette::extent_of(const PaletteScan& scan, double reach) const {
  const double least = is_dual() ? 1 : kLeastLinear;
  const double growth = is_dual() ? 1.76 * dual_influences_ : 1;
  const double sum =
      std::max(double{scan.linear}, least) * reach + growth * double{scan.translation};
  return std::nextafter(static_cast<float>(sum), std::numeric_limits<float>::infinity());
}

void Palette::keep(const PaletteScan& scan) {
  scan_ = scan;
  extent_ = extent_of(scan_, reach_);
  const auto growth = std::nextafter(static_cast<float>(reach_ - double{rest_extent_}),
                                     std::numeric_limits<float>::infinity());
  if (!links_.empty())
    link_hull_ = move_links(links_, {duals_.data(), joints_.data()}, growth, link_slack(),
                            link_motions_.data());
}

/// Skips the check of the joints if the weights displace no farther than before. This is necessary
/// because the constructor's joints may exceed kMaxCoordinate.
Result<void> Palette::set_morph_weights(std::span<const float> weights) {
  if (Problem found = morphs_.check(weights); !found.empty())
    return invalid_argument(std::move(found));
  const double reach = double{rest_extent_} + morphs_.extent_of(weights);
  if (reach > reach_ && !are_good(scan_, reach))
    if (Problem found = find_bad_joint(floats_of(joints_), reach); !found.empty())
      return invalid_argument("morph_weights are too large: " + std::move(found));
  morphs_.set(weights);
  reach_ = reach;
  keep(scan_);
  return {};
}

bool Palette::are_good(const PaletteScan& joints, double reach) const {
  return joints.is_affine && extent_of(joints, reach) <= kMaxCoordinate;
}

/// Checks the joints one by one; joints that are valid alone are valid together.
Problem Palette::find_bad_joint(std::span<const float> floats, double reach) const {
  return first_problem([&](std::size_t joint) {
    const float* const matrix = &floats[16 * joint];
    return are_good(scan_palette(matrix, 1), reach) ? Problem() : describe(matrix, joint);
  });
}

}  // namespace pelt::detail
