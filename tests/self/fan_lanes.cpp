/// Compiled once for each instruction set. The test itself runs on any machine.
#include "fan_lanes.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

unsigned flat_fans(const detail::Fans& fans, detail::FanKind kind, std::uint32_t first,
                   std::uint32_t count, const FanPositions& positions) {
  return detail::flat_fans(fans, kind, first, count, positions.data());
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
