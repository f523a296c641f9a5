#include "self/cluster_pairs.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

void ClusterPairs::flush() {
  struct Row {
    std::uint8_t pair, triangle;
    std::uint16_t lanes;
  };
  Row found[kRoom * kMaxClusterTriangles + 1];
  std::uint32_t found_count = 0;
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const unsigned p = rows_.row(i), row = rows_.lane(i);
    const Waiting& pair = waiting_[p];
    const unsigned lanes = pair.lanes & ~unsigned{pair.skipped[row]} &
                           overlapping(load_boxes(*pair.boxes_b), repeat_box(*pair.boxes_a, row));
    found[found_count] = {static_cast<std::uint8_t>(p), static_cast<std::uint8_t>(row),
                          static_cast<std::uint16_t>(lanes)};
    found_count += lanes != 0;
  }
  for (const Row *row = found, *end = found + found_count; row != end;) {
    const Waiting& pair = waiting_[row->pair];
    RowLanes pairs;
    for (const Row* first = row; row != end && row->pair == first->pair; ++row)
      pairs.add(row->triangle, row->lanes);
    triangles_.add(cluster(pair.a), cluster(pair.b), pairs);
  }
  rows_ = RowLanes();
  count_ = 0;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
