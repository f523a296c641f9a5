#pragma once

/// Poses a pool of a model with dual quaternion skinning, eight vertices at a time.

#include "geometry/points8.hpp"
#include "model/tree.hpp"
#include "skin/dual_skin.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Loads the dual quaternions `at(0)` to `at(7)`.
template <typename At>
inline Dual<Float8> gather_duals(const At& at) {
  const DualQuaternion* q[8];
  for (std::uint32_t lane = 0; lane < 8; ++lane) q[lane] = at(lane);
  const auto real = [&](int lane) { return load4(q[lane]->real); };
  const auto dual = [&](int lane) { return load4(q[lane]->dual); };
  const Rows8 r = rows8(real(0), real(1), real(2), real(3), real(4), real(5), real(6), real(7));
  const Rows8 e = rows8(dual(0), dual(1), dual(2), dual(3), dual(4), dual(5), dual(6), dual(7));
  return {r.x, r.y, r.z, r.w, e.x, e.y, e.z, e.w};
}

/// The influences of up to eight vertices of a pool. Lanes beyond the last vertex repeat it.
class Influences8 {
 public:
  Influences8(const Tree& tree, std::uint32_t place, std::uint32_t last)
      : joints_(tree.joints.data()), weights_(tree.weights.data()) {
    const std::uint32_t* begin = tree.influence_begin.data() + place;
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      const std::uint32_t vertex = lane < last ? lane : last;
      begin_[lane] = begin[vertex];
      count_[lane] = begin[vertex + 1] - begin[vertex];
    }
  }

  /// The largest number of influences, because a pool is sorted by it.
  std::uint32_t count() const { return count_[7]; }

  Dual<Float8> duals(std::uint32_t k, const DualQuaternion* palette) const {
    if (k < count_[0])  // all lanes have it
      return gather_duals([&](std::uint32_t lane) { return palette + joints_[begin_[lane] + k]; });
    return gather_duals(
        [&](std::uint32_t lane) { return palette + joints_[begin_[lane] + known(lane, k)]; });
  }

  /// A lane without influence k has the weight zero.
  Float8 weights(std::uint32_t k) const {
    float weights[8];
    if (k < count_[0]) {
      for (std::uint32_t lane = 0; lane < 8; ++lane) weights[lane] = weights_[begin_[lane] + k];
      return load8(weights);
    }
    for (std::uint32_t lane = 0; lane < 8; ++lane)
      weights[lane] = k < count_[lane] ? weights_[begin_[lane] + k] : 0;
    return load8(weights);
  }

 private:
  std::uint32_t known(std::uint32_t lane, std::uint32_t k) const {
    return k < count_[lane] ? k : 0;
  }

  const std::uint16_t* joints_;
  const float* weights_;
  std::uint32_t begin_[8], count_[8];
};

inline Dual<Float8> blend8(const Influences8& influences, const DualQuaternion* palette) {
  const Float8 zero(0.0f);
  const Dual<Float8> pivot = influences.duals(0, palette);
  Dual<Float8> sum = {zero, zero, zero, zero, zero, zero, zero, zero};
  add(sum, influences.weights(0), pivot);
  for (std::uint32_t k = 1; k < influences.count(); ++k) {
    const Dual<Float8> dual = influences.duals(k, palette);
    const Float8 weights = influences.weights(k);
    add(sum, select(dot(pivot, dual) < zero, zero - weights, weights), dual);
  }
  return sum;
}

/// `rest_at(place, out)` returns the rest position of a vertex, where `out` is the destination of
/// the posed vertex.
template <typename RestAt>
void pose_dual_pool(const Tree& tree, const RestAt& rest_at, const DualQuaternion* palette,
                    std::uint32_t place, std::uint32_t end, float* out) {
  for (; place < end; place += 8, out += std::size_t{8} * kFloatsPerVertex) {
    const std::uint32_t last = end - place < 8 ? end - place - 1 : 7;
    float rest[3][8];
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      const std::uint32_t vertex = lane < last ? lane : last;
      const Vec3 v = rest_at(place + vertex, out + std::size_t{kFloatsPerVertex} * vertex);
      rest[0][lane] = v.x, rest[1][lane] = v.y, rest[2][lane] = v.z;
    }
    Points8 p = {load8(rest[0]), load8(rest[1]), load8(rest[2])};
    move_point(blend8(Influences8(tree, place, last), palette), p.x, p.y, p.z);
    Float4 posed[8];
    points_of(p, posed);
    for (std::uint32_t lane = 0; lane <= last; ++lane)
      store4(out + std::size_t{kFloatsPerVertex} * lane, posed[lane]);
  }
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
