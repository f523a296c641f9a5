#pragma once

/// Poses a pool of a model with dual quaternion skinning.

#include "geometry/points8.hpp"
#include "pose/vertex_arrays.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Most vertices that are blended before they are moved.
inline constexpr std::size_t kDualGroup = 32;

/// The sums of the weighted dual quaternions of vertices, with the real part before the dual part.
struct alignas(32) DualSums {
  float sums[kDualGroup][8];

  float* operator[](std::size_t i) { return sums[i]; }
  const float* operator[](std::size_t i) const { return sums[i]; }
};

/// Poses vertices of a tree in groups. Its functions are inlined, so that its members are in
/// registers; otherwise the compiler reloads them after every store.
template <typename RestAt>
class DualPoser {
 public:
  DualPoser(const Tree& tree, const RestAt& rest_at, const Palette& palette)
      : arrays_(tree),
        rest_at_(rest_at),
        duals_(palette.duals().data()),
        may_negate_(!palette.negates_none()) {}

  /// Poses `count` vertices, at most kDualGroup.
  [[gnu::always_inline]] void pose(std::size_t place, std::size_t count, float* out) const {
    DualSums sums;
    if (may_negate_)
      blend_negating(place, count, sums);
    else
      blend(place, count, sums);
    std::size_t first = 0;
    for (; first + 8 <= count; first += 8)
      move(sums, place, out, [first](std::size_t i) { return first + i; });
    const std::size_t last = count - 1;
    if (first < count)
      move(sums, place, out, [=](std::size_t i) { return std::min(first + i, last); });
  }

 private:
  /// Pools are sorted by number of influences, and a loop of known length needs no branch.
  [[gnu::always_inline]] void blend(std::size_t place, std::size_t count, DualSums& sums) const {
    std::size_t i = 0;
    i = blend_run<1>(place, i, count, sums);
    i = blend_run<2>(place, i, count, sums);
    i = blend_run<3>(place, i, count, sums);
    i = blend_run<4>(place, i, count, sums);
    for (; i < count; ++i) blend_one(place + i, arrays_.influence_count(place + i), sums[i]);
  }

  template <std::uint32_t kCount>
  [[gnu::always_inline]] std::size_t blend_run(std::size_t place, std::size_t i, std::size_t count,
                                               DualSums& sums) const {
    for (; i < count && arrays_.influence_count(place + i) == kCount; ++i)
      blend_one(place + i, kCount, sums[i]);
    return i;
  }

  [[gnu::always_inline]] void blend_one(std::size_t place, std::uint32_t count, float* out) const {
    const auto influence = arrays_.influences(place);
    Float8 sum(0.0f);
    for (std::uint32_t k = 0; k < count; ++k)
      sum = sum + Float8(influence(k).weight) * load8(duals_[influence(k).joint].real);
    sum.store(out);
  }

  /// Some dual quaternions may count negated.
  void blend_negating(std::size_t place, std::size_t count, DualSums& sums) const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto influence = arrays_.influences(place + i);
      const Dual<float> pivot = dual_of(duals_[influence(0).joint]);
      Float8 sum(0.0f);
      for (std::uint32_t k = 0; k < arrays_.influence_count(place + i); ++k) {
        const Influence next = influence(k);
        const bool is_negated = dot(pivot, dual_of(duals_[next.joint])) < 0;
        sum =
            sum + Float8(is_negated ? -next.weight : next.weight) * load8(duals_[next.joint].real);
      }
      sum.store(sums[i]);
    }
  }

  /// Moves eight vertices by their sums. `number(i)` is the number of the i-th in the group; fewer
  /// than eight repeat the last one, and write it repeatedly.
  template <typename Number>
  [[gnu::always_inline]] void move(const DualSums& sums, std::size_t place, float* out,
                                   const Number& number) const {
    const auto posed = [&](std::size_t i) { return out + kFloatsPerVertex * number(i); };
    const Rows8 v =
        rows([&](std::size_t i) { return load3(rest_at_(place + number(i), posed(i))); });
    const Rows8 r = rows([&](std::size_t i) { return load4(sums[number(i)]); });
    const Rows8 e = rows([&](std::size_t i) { return load4(sums[number(i)] + 4); });
    Points8 p = {v.x, v.y, v.z};
    move_point<Float8>({r.x, r.y, r.z, r.w, e.x, e.y, e.z, e.w}, p.x, p.y, p.z);
    Float4 points[8];
    points_of(p, points);
    for (std::size_t i = 0; i < 8; ++i) store4(posed(i), points[i]);
  }

  template <typename Row>
  [[gnu::always_inline]] static Rows8 rows(const Row& row) {
    return rows8(row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7));
  }

  VertexArrays arrays_;
  const RestAt& rest_at_;
  const DualQuaternion* duals_;
  bool may_negate_;
};

/// `rest_at(place, out)` returns the three coordinates of the rest position of a vertex, where
/// `out` is the destination of the posed vertex.
template <typename RestAt>
void pose_dual_pool(const Tree& tree, const RestAt& rest_at, const Palette& palette,
                    std::size_t place, std::size_t end, float* out) {
  const DualPoser<RestAt> poser(tree, rest_at, palette);
  for (; place < end; place += kDualGroup, out += kDualGroup * kFloatsPerVertex)
    poser.pose(place, std::min(end - place, kDualGroup), out);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
