#include "pose/root_box.hpp"

#include "model/node_box.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

RootBox box_root(const NodeBounds& bounds, const Palette& palette, const GivenVertices& given) {
  const Box4 box = given ? Box4{load4(given.boxes[0].low), load4(given.boxes[0].high)}
                         : node_box(bounds, 0, palette);
  RootBox root;
  root.known = true;
  store4(root.low, box.low);
  store4(root.high, box.high);
  return root;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
