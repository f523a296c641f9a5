#include "pose/instance_box.hpp"

#include "model/node_box.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

RootBox instance_box(const NodeBounds& bounds, const Palette& palette) {
  const Box4 box = node_box(bounds, 0, palette);
  RootBox root;
  root.known = true;
  store4(root.low, box.low);
  store4(root.high, box.high);
  return root;
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
