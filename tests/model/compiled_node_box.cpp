/// Compiled once for each instruction set. The test itself runs on any machine.
#include "compiled_node_box.hpp"

#include "model/node_box.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

PlainBox compiled_node_box(const detail::NodeBounds& bounds, std::uint32_t node,
                           const detail::Palette& palette) {
  const detail::Box4 box = detail::node_box(bounds, node, palette);
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

PlainBox compiled_dual_box(const detail::NodeBounds& bounds, std::uint32_t node,
                           const detail::Palette& palette, float tolerance) {
  const detail::Box4 box =
      detail::dual_box(bounds, node, palette, detail::linear_box(bounds, node, palette), tolerance);
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
