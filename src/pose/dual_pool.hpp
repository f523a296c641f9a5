#pragma once

/// Poses a pool of a model with dual quaternion skinning.

#include "geometry/points8.hpp"
#include "pose/vertex_arrays.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Most vertices that are blended before they are moved.
inline constexpr std::uint32_t kDualGroup = 32;

/// Vertices: their rest positions, and the sums of their weighted dual quaternions with the real
/// part before the dual part.
struct DualGroup {
  alignas(32) float rest[kDualGroup][4];
  alignas(32) float sums[kDualGroup][8];

  /// Repeats the first vertex after `count` others, to a multiple of eight.
  void fill_from(std::uint32_t count) {
    for (; count % 8 > 0; ++count) {
      store4(rest[count], load4(rest[0]));
      load8(sums[0]).store(sums[count]);
    }
  }

  /// The posed vertices of the eight that begin with `first`.
  [[gnu::always_inline]] void move(std::uint32_t first, Float4 (&points)[8]) const {
    const Rows8 v = rows_at([&](std::uint32_t i) { return rest[first + i]; });
    const Rows8 r = rows_at([&](std::uint32_t i) { return sums[first + i]; });
    const Rows8 e = rows_at([&](std::uint32_t i) { return sums[first + i] + 4; });
    Points8 p = {v.x, v.y, v.z};
    move_point<Float8>({r.x, r.y, r.z, r.w, e.x, e.y, e.z, e.w}, p.x, p.y, p.z);
    points_of(p, points);
  }

 private:
  template <typename RowAt>
  static Rows8 rows_at(const RowAt& at) {
    return rows8(load4(at(0)), load4(at(1)), load4(at(2)), load4(at(3)), load4(at(4)), load4(at(5)),
                 load4(at(6)), load4(at(7)));
  }
};

/// Poses vertices of a tree in groups.
template <typename RestAt>
class DualPoser {
 public:
  DualPoser(const Tree& tree, const RestAt& rest_at, const Palette& palette)
      : arrays_(tree),
        rest_at_(rest_at),
        duals_(palette.duals().data()),
        may_negate_(!palette.negates_none()) {}

  /// Poses `count` vertices, at most kDualGroup.
  void pose(std::uint32_t place, std::uint32_t count, float* out) const {
    DualGroup group;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3& v = rest_at_(place + i, out + std::size_t{kFloatsPerVertex} * i);
      store4(group.rest[i], Float4(v.x, v.y, v.z, 0));
    }
    if (may_negate_)
      blend_negating(place, count, group);
    else
      blend(place, count, group);
    group.fill_from(count);
    for (std::uint32_t first = 0; first < count; first += 8) {
      Float4 points[8];
      group.move(first, points);
      for (std::uint32_t i = first; i < count && i < first + 8; ++i)
        store4(out + std::size_t{kFloatsPerVertex} * i, points[i - first]);
    }
  }

 private:
  /// Pools are sorted by number of influences, and a loop of known length needs no branch.
  void blend(std::uint32_t place, std::uint32_t count, DualGroup& group) const {
    std::uint32_t i = 0;
    i = blend_run<1>(place, i, count, group);
    i = blend_run<2>(place, i, count, group);
    i = blend_run<3>(place, i, count, group);
    i = blend_run<4>(place, i, count, group);
    for (; i < count; ++i) blend_one(place + i, arrays_.influence_count(place + i), group.sums[i]);
  }

  template <std::uint32_t kCount>
  std::uint32_t blend_run(std::uint32_t place, std::uint32_t i, std::uint32_t count,
                          DualGroup& group) const {
    for (; i < count && arrays_.influence_count(place + i) == kCount; ++i)
      blend_one(place + i, kCount, group.sums[i]);
    return i;
  }

  [[gnu::always_inline]] void blend_one(std::uint32_t place, std::uint32_t count,
                                        float* out) const {
    const auto influence = arrays_.influences(place);
    Float8 sum(0.0f);
    for (std::uint32_t k = 0; k < count; ++k)
      sum = sum + Float8(influence(k).weight) * load8(duals_[influence(k).joint].real);
    sum.store(out);
  }

  /// Some dual quaternions may count negated.
  void blend_negating(std::uint32_t place, std::uint32_t count, DualGroup& group) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto influence = arrays_.influences(place + i);
      const Dual<float> pivot = dual_of(duals_[influence(0).joint]);
      Float8 sum(0.0f);
      for (std::uint32_t k = 0; k < arrays_.influence_count(place + i); ++k) {
        const Influence next = influence(k);
        const bool is_negated = dot(pivot, dual_of(duals_[next.joint])) < 0;
        sum =
            sum + Float8(is_negated ? -next.weight : next.weight) * load8(duals_[next.joint].real);
      }
      sum.store(group.sums[i]);
    }
  }

  VertexArrays arrays_;
  const RestAt& rest_at_;
  const DualQuaternion* duals_;
  bool may_negate_;
};

/// `rest_at(place, out)` returns the rest position of a vertex, where `out` is the destination of
/// the posed vertex.
template <typename RestAt>
void pose_dual_pool(const Tree& tree, const RestAt& rest_at, const Palette& palette,
                    std::uint32_t place, std::uint32_t end, float* out) {
  const DualPoser<RestAt> poser(tree, rest_at, palette);
  for (; place < end; place += kDualGroup, out += std::size_t{kDualGroup} * kFloatsPerVertex)
    poser.pose(place, end - place < kDualGroup ? end - place : kDualGroup, out);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
