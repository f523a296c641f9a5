#pragma once

/// Which pairs of triangles of two clusters share a surface vertex. A descent of a tree against
/// itself skips these pairs, and clusters are usually the neighbours of several others.

#include "self/fans.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// One bit for each pair of triangles of two clusters: bit t of row s for triangle s of the first
/// cluster and triangle t of the second.
struct PairMask {
  std::uint16_t rows[kMaxClusterTriangles] = {};

  void set(std::uint32_t row, std::uint32_t lane) {
    rows[row] = static_cast<std::uint16_t>(rows[row] | 1u << lane);
  }
};

struct PairMasks {
  PairMasks(const Tree& tree, const Fans& fans);

  /// Masks of the clusters that share a surface vertex, and of each cluster with itself. The
  /// partners of a cluster are not lower than the cluster, and ascend. In the mask of a cluster
  /// with itself, bits with t <= s are set, too.
  std::vector<std::uint32_t> begin;  // [C + 1] into partners and masks
  std::vector<std::uint32_t> partners;
  std::vector<PairMask> masks;
  std::vector<std::uint32_t> cluster_nodes;  // [C] node of each cluster

  /// A hub is a surface vertex with so many triangles that the masks of their clusters would need
  /// too much memory. `masks` does not cover pairs that share only hubs.
  std::vector<std::uint8_t> has_hub;  // [C] whether a triangle of the cluster has a hub

  /// Writes a mask as in `masks`, for clusters with hubs. Precondition: low <= high.
  void write_mask(const Tree& tree, const Fans& fans, std::uint32_t low, std::uint32_t high,
                  PairMask& mask) const;

  /// Returns the mask of two clusters, or null if there is none. Precondition: low <= high.
  const PairMask* find(std::uint32_t low, std::uint32_t high) const {
    for (std::uint32_t i = begin.data()[low]; i < begin.data()[low + 1]; ++i)
      if (partners.data()[i] == high) return &masks.data()[i];
    return nullptr;
  }

 private:
  /// Writes `masks`, `partners` and `begin` from packed pairs.
  void write_masks(const std::vector<std::uint64_t>& sorted, std::size_t cluster_count);
};

}  // namespace pelt::detail
