/// Compiled once for each instruction set. The test itself runs on any machine.
#include "fan_lanes.hpp"

#include <algorithm>

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

TestedFans test_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                     std::uint32_t count, const FanPositions& positions) {
  std::uint32_t numbers[8] = {};
  for (std::uint32_t i = 0; i < count; ++i) numbers[i] = first + i;
  detail::UndecidedPairs undecided;
  TestedFans tested;
  tested.certified =
      detail::test_flat_fans(fans, run, numbers, count, positions.data(), undecided).certified;
  for (std::uint32_t lane = 0; lane < count; ++lane)
    if (!(tested.certified >> lane & 1))
      std::copy_n(undecided.rows[lane], run.size, tested.undecided[lane].begin());
  return tested;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
