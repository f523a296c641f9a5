#include <pelt/query.hpp>

namespace pelt {

QueryStats& QueryStats::operator+=(const QueryStats& other) {
  node_pairs += other.node_pairs;
  refits += other.refits;
  posed_vertices += other.posed_vertices;
  triangle_pairs += other.triangle_pairs;
  displacements += other.displacements;
  clamped_offsets += other.clamped_offsets;
  cut_short = cut_short || other.cut_short;
  return *this;
}

std::uint64_t work_of(const QueryStats& stats) {
  return kNodePairWork * stats.node_pairs + kRefitWork * stats.refits +
         kPosedVertexWork * stats.posed_vertices + kTrianglePairWork * stats.triangle_pairs +
         kDisplacementWork * stats.displacements;
}

}  // namespace pelt
