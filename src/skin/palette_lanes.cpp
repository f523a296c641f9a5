/// Four motions at a time. A group of fewer repeats the last motion, and writes it repeatedly.

#include "skin/palette_lanes.hpp"
#include "base/double4.hpp"
#include "base/float8.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

float largest_coordinate(const Float4& v) {
  const float xy = v[0] > v[1] ? v[0] : v[1];
  return xy > v[2] ? xy : v[2];
}

}  // namespace

PaletteScan scan_palette(const float* floats, std::size_t joint_count) {
  const Float8 last_columns(Float4(0.0f), Float4(0, 0, 0, 1));
  const Float8 most(std::numeric_limits<float>::max());
  Float8 xy_largest(0.0f), zt_largest(0.0f), sum_largest(0.0f);
  Mask8 finite = sum_largest <= most;
  for (const float* m = floats; m != floats + 16 * joint_count; m += 16) {
    const Float8 xy = load8(m), zt = load8(m + 8);
    const Float8 sum = abs(xy) + abs(zt - last_columns);
    xy_largest = max(xy_largest, abs(xy));
    zt_largest = max(zt_largest, abs(zt));
    sum_largest = max(sum_largest, sum);
    finite = finite & (sum <= most);  // false for NaN, too
  }
  const Float4 last_rows = fold(sum_largest);
  const Float4 linear = max(max(xy_largest.low(), xy_largest.high()), zt_largest.low());
  return {largest_coordinate(linear), largest_coordinate(zt_largest.high()),
          last_rows[3] == 0 && finite.bits() == 0xFF};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Four quaternions; r has their vector parts.
struct Quaternion4 {
  Vec3d4 r;
  Double4 w;
};

Quaternion4 operator*(const Double4& s, const Quaternion4& q) { return {s * q.r, s * q.w}; }

Double4 dot(const Quaternion4& a, const Quaternion4& b) { return dot(a.r, b.r) + a.w * b.w; }

Quaternion4 select(const MaskDouble4& mask, const Quaternion4& yes, const Quaternion4& no) {
  return {
      {select(mask, yes.r.x, no.r.x), select(mask, yes.r.y, no.r.y), select(mask, yes.r.z, no.r.z)},
      select(mask, yes.w, no.w)};
}

/// The numbers of four motions.
using MotionGroup = std::size_t[4];

template <typename Visit>
void for_each_group(std::size_t count, const Visit& visit) {
  const std::size_t last = count - 1;
  for (std::size_t i = 0; i < count; i += 4)
    visit(MotionGroup{i, std::min(i + 1, last), std::min(i + 2, last), std::min(i + 3, last)});
}

/// Reads four floats of each motion; `row(i)` points to those of motion i.
template <typename RowOf>
Quaternion4 load_rows(const MotionGroup& group, const RowOf& row) {
  Float4 x = load4(row(group[0])), y = load4(row(group[1]));
  Float4 z = load4(row(group[2])), w = load4(row(group[3]));
  transpose(x, y, z, w);
  return {{Double4(x), Double4(y), Double4(z)}, Double4(w)};
}

/// Writes them, rounded.
template <typename RowOf>
void store_rows(const Quaternion4& q, const MotionGroup& group, const RowOf& row) {
  Float4 a = q.r.x.rounded(), b = q.r.y.rounded(), c = q.r.z.rounded(), d = q.w.rounded();
  transpose(a, b, c, d);
  store4(row(group[0]), a), store4(row(group[1]), b);
  store4(row(group[2]), c), store4(row(group[3]), d);
}

/// Largest magnitude of A^T A - I.
Double4 deviation(const Vec3d4 (&axes)[3]) {
  Double4 most(0.0);
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column) {
      const Double4 error = dot(axes[row], axes[column]) - Double4(row == column ? 1 : 0);
      most = max(most, max(error, -error));
    }
  return most;
}

bool are_rigid(const Vec3d4 (&axes)[3]) {
  const Double4 determinant = dot(cross(axes[0], axes[1]), axes[2]);
  return !(Double4(kRigidTolerance) < deviation(axes)).any() && !(determinant < Double4(0.0)).any();
}

/// Returns quaternions that are parallel to those of the rotations with these columns. Solves for
/// the largest element, so that nothing cancels.
Quaternion4 rotations_of(const Vec3d4& x, const Vec3d4& y, const Vec3d4& z) {
  const Double4 one(1.0);
  const Double4 xx = one + x.x - y.y - z.z, yy = one - x.x + y.y - z.z;
  const Double4 zz = one - x.x - y.y + z.z, ww = one + x.x + y.y + z.z;
  const Double4 xy = x.y + y.x, xz = x.z + z.x, yz = y.z + z.y;
  const Double4 xw = y.z - z.y, yw = z.x - x.z, zw = x.y - y.x;

  Quaternion4 best = {{xx, xy, xz}, xw};
  Double4 largest = xx;
  const auto take_larger = [&](const Double4& square, const Quaternion4& q) {
    best = select(largest < square, q, best);
    largest = max(largest, square);
  };
  take_larger(yy, {{xy, yy, yz}, yw});
  take_larger(zz, {{xz, yz, zz}, zw});
  take_larger(ww, {{xw, yw, zw}, ww});
  return best;
}

/// The product of half the translation, as a quaternion, and q.
Quaternion4 dual_part(const Vec3d4& translation, const Quaternion4& q) {
  return Double4(0.5) *
         Quaternion4{q.w * translation + cross(translation, q.r), -dot(translation, q.r)};
}

/// The largest coordinate of any vector, or infinity if one is not finite.
class LargestCoordinate {
 public:
  void include(const Vec3d4& v) {
    const Double4 x = max(v.x, -v.x), y = max(v.y, -v.y), z = max(v.z, -v.z);
    largest_ = max(largest_, max(x, max(y, z)));
    is_finite_ &= (x + y + z < Double4(kInfinity)).bits() == 0xF;  // false for NaN, too
  }

  float get() const {
    double lanes[4];
    largest_.store(lanes);
    return static_cast<float>(is_finite_ ? *std::max_element(lanes, lanes + 4) : kInfinity);
  }

 private:
  Double4 largest_{0.0};
  bool is_finite_ = true;
};

bool are_unit(const Double4& squared_lengths) {
  const Double4 error = squared_lengths - Double4(1.0), tolerance(kRigidTolerance);
  return (squared_lengths < Double4(2.0)).bits() == 0xF && !(tolerance < max(error, -error)).any();
}

/// Squares of floats do not overflow.
bool are_finite(const Quaternion4& q) { return (dot(q, q) < Double4(kInfinity)).bits() == 0xF; }

}  // namespace

bool find_rigid_motions(const float* matrices, std::size_t count, DualQuaternion* out) {
  bool all_rigid = true;
  for_each_group(count, [&](const MotionGroup& group) {
    const auto column = [&](std::size_t number) {
      return load_rows(group, [&](std::size_t i) { return matrices + 16 * i + 4 * number; }).r;
    };
    const Vec3d4 axes[] = {column(0), column(1), column(2)};
    all_rigid &= are_rigid(axes);
    const Quaternion4 parallel = rotations_of(axes[0], axes[1], axes[2]);
    const Quaternion4 q = Double4(1.0) / sqrt(dot(parallel, parallel)) * parallel;
    store_rows(q, group, [&](std::size_t i) { return out[i].real; });
    store_rows(dual_part(column(3), q), group, [&](std::size_t i) { return out[i].dual; });
  });
  return all_rigid;
}

bool normalise_duals(const float* duals, std::size_t count, DualQuaternion* out) {
  bool all_unit = true;
  for_each_group(count, [&](const MotionGroup& group) {
    const Quaternion4 q = load_rows(group, [&](std::size_t i) { return duals + 8 * i; });
    const Quaternion4 e = load_rows(group, [&](std::size_t i) { return duals + 8 * i + 4; });
    const Double4 square = dot(q, q);
    all_unit &= are_unit(square) && are_finite(e);
    const Double4 along = dot(q, e) / square, scale = Double4(1.0) / sqrt(square);
    const Quaternion4 dual = {e.r - along * q.r, e.w - along * q.w};
    store_rows(scale * q, group, [&](std::size_t i) { return out[i].real; });
    store_rows(scale * dual, group, [&](std::size_t i) { return out[i].dual; });
  });
  return all_unit;
}

float find_matrices(const DualQuaternion* motions, std::size_t count, Matrix4* out) {
  LargestCoordinate farthest;
  for_each_group(count, [&](const MotionGroup& group) {
    const Quaternion4 q = load_rows(group, [&](std::size_t i) { return motions[i].real; });
    const Quaternion4 e = load_rows(group, [&](std::size_t i) { return motions[i].dual; });
    const Double4 one(1.0), s = Double4(2.0) / dot(q, q);
    const Double4 &x = q.r.x, &y = q.r.y, &z = q.r.z, &w = q.w;
    const Vec3d4 columns[] = {{one - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
                              {s * (x * y - w * z), one - s * (x * x + z * z), s * (y * z + w * x)},
                              {s * (x * z + w * y), s * (y * z - w * x), one - s * (x * x + y * y)},
                              s * (w * e.r - e.w * q.r + cross(q.r, e.r))};
    for (std::size_t column = 0; column < 4; ++column)
      store_rows({columns[column], column == 3 ? one : Double4(0.0)}, group,
                 [&](std::size_t i) { return &out[i].m[4 * column]; });
    farthest.include(columns[3]);
  });
  return farthest.get();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
