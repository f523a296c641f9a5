#pragma once

/// Poses the vertices of a pool: rest positions, displaced by morph targets, and moved by linear
/// blend skinning or by dual quaternions.

#include "geometry/points8.hpp"
#include "model/tree.hpp"
#include "skin/skin.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Plain pointers to the arrays of the tree's vertices; otherwise the compiler reloads the vectors'
/// data pointers after every store.
struct VertexArrays {
  explicit VertexArrays(const Tree& tree)
      : influence_begin(tree.influence_begin.data()),
        joints(tree.joints.data()),
        weights(tree.weights.data()) {}

  std::uint32_t influence_count(std::size_t place) const {
    return influence_begin[place + 1] - influence_begin[place];
  }

  /// Returns the influences of the vertex at `place` as a function of their number.
  [[gnu::always_inline]] auto influences(std::size_t place) const {
    const std::uint16_t* joint = joints + influence_begin[place];
    const float* weight = weights + influence_begin[place];
    return [=](std::uint32_t i) { return Influence{joint[i], weight[i]}; };
  }

  /// Poses the vertex at `place` with `count` influences and the rest position `rest`.
  [[gnu::always_inline]] Float4 pose(const Vec3& rest, std::uint32_t place, std::uint32_t count,
                                     const Matrix4* palette) const {
    return posed_vertex4(rest, count, influences(place), palette);
  }

  Float4 pose(const Vec3& rest, std::uint32_t place, const Palette& palette) const {
    const std::uint32_t count = influence_count(place);
    return palette.is_dual()
               ? dual_posed_vertex4(rest, count, influences(place), palette.duals().data())
               : pose(rest, place, count, palette.joints().data());
  }

  const std::uint32_t* influence_begin;
  const std::uint16_t* joints;
  const float* weights;
};

/// Returns the number of displacements by active morph targets in a node's pool.
inline std::uint64_t displacement_count(const Tree& tree, std::uint32_t index,
                                        const MorphWeights& morphs) {
  const PoolTarget* targets = tree.morphs.targets.data();
  const std::uint32_t* begin = tree.morphs.node_begin.data() + index;
  std::uint64_t count = 0;
  each_active(targets + begin[0], targets + begin[1], morphs,
              [&](const PoolTarget& target) { count += target.displacement_count; });
  return count;
}

/// Writes the rest positions of a node's pool, displaced by the active morph targets, to `out` in
/// the layout of posed vertices. Returns the number of displacements; if it is 0, writes nothing.
inline std::uint64_t morph_pool(const Tree& tree, std::uint32_t index, const MorphWeights& morphs,
                                float* out) {
  const Node& node = tree.nodes[index];
  const PoolTarget* targets = tree.morphs.targets.data();
  const std::uint32_t* begin = tree.morphs.node_begin.data() + index;
  std::uint64_t displaced_count = 0;
  each_active(targets + begin[0], targets + begin[1], morphs, [&](const PoolTarget& target) {
    if (displaced_count == 0)
      for (std::uint32_t v = 0; v < node.vertex_count; ++v) {
        const Vec3& rest = tree.rest_positions[node.first_vertex + v];
        float* to = out + std::size_t{kFloatsPerVertex} * v;
        to[0] = rest.x, to[1] = rest.y, to[2] = rest.z;
      }
    const PlacedDisplacement* displacement =
        tree.morphs.displacements.data() + target.first_displacement;
    for (std::uint32_t i = 0; i < target.displacement_count; ++i, ++displacement) {
      float* at = out + std::size_t{kFloatsPerVertex} * (displacement->place - node.first_vertex);
      const Vec3 v = displaced({at[0], at[1], at[2]}, morphs[target.target], displacement->by);
      at[0] = v.x, at[1] = v.y, at[2] = v.z;
    }
    displaced_count += target.displacement_count;
  });
  return displaced_count;
}

/// Random access to the rest positions of a tree, displaced by the active morph targets.
/// Precondition: the tree has morph targets. Cost of a vertex: O(1) in a pool that no active target
/// displaces, otherwise O(log) of the pool's displacements for each target that does, and O(log N)
/// more if the pool is not that of the previous vertex.
class MorphedRest {
 public:
  MorphedRest(const Tree& tree, const MorphWeights& morphs) : tree_(tree), morphs_(morphs) {}

  Vec3 operator()(std::uint32_t place) {
    if (place < first_place_ || place >= end_place_) find_pool(place);
    Vec3 v = tree_.rest_positions[place];
    each_active(begin_, end_, morphs_, [&](const PoolTarget& target) {
      if (const PlacedDisplacement* found = find(target, place)) {
        v = displaced(v, morphs_[target.target], found->by);
        ++displacement_count_;
      }
    });
    return v;
  }

  /// Number of displacements of the vertices so far.
  std::uint64_t displacement_count() const { return displacement_count_; }

 private:
  /// Finds the last node whose pool does not begin behind `place`. Vertices without triangles
  /// follow all pools, as if they belonged to one more node.
  void find_pool(std::uint32_t place) {
    const Node* nodes = tree_.nodes.data();
    const auto node_count = static_cast<std::uint32_t>(tree_.nodes.size());
    std::uint32_t index = 0;
    for (std::uint32_t count = node_count; count > 1;) {
      const std::uint32_t half = count / 2;
      index += nodes[index + half].first_vertex <= place ? half : 0;
      count -= half;
    }
    first_place_ = nodes[index].first_vertex;
    end_place_ = first_place_ + nodes[index].vertex_count;
    if (place >= end_place_) {
      index = node_count;
      first_place_ = end_place_;
      end_place_ = static_cast<std::uint32_t>(tree_.rest_positions.size());
    }
    const std::uint32_t* begin = tree_.morphs.node_begin.data() + index;
    begin_ = tree_.morphs.targets.data() + begin[0];
    end_ = tree_.morphs.targets.data() + begin[1];
  }

  /// Returns the displacement of the vertex at `place` by the target, or null.
  const PlacedDisplacement* find(const PoolTarget& target, std::uint32_t place) const {
    const PlacedDisplacement* first = tree_.morphs.displacements.data() + target.first_displacement;
    for (std::uint32_t count = target.displacement_count; count > 1;) {
      const std::uint32_t half = count / 2;
      first += first[half].place <= place ? half : 0;
      count -= half;
    }
    return first->place == place ? first : nullptr;
  }

  const Tree& tree_;
  const MorphWeights& morphs_;
  std::uint64_t displacement_count_ = 0;
  std::uint32_t first_place_ = 0, end_place_ = 0;       // range of the current pool
  const PoolTarget *begin_ = nullptr, *end_ = nullptr;  // targets of the current pool
};

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
