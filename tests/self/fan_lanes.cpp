/// Compiled once for each instruction set. The test itself runs on any machine.
#include "fan_lanes.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

unsigned flat_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                   std::uint32_t count, const FanPositions& positions) {
  std::uint32_t numbers[8];
  for (std::uint32_t i = 0; i < count; ++i) numbers[i] = first + i;
  return detail::test_flat_fans(fans, run, numbers, count, positions.data()).certified;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
