#pragma once

#include "model/tree.hpp"
#include "skin/skin.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
