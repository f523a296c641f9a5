#pragma once

#include "self/flat_fans.hpp"
#include "support/compiled.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::test {

using FanPositions = std::vector<std::array<float, 4>>;

/// The result of `test_flat_fans` for up to eight fans.
struct TestedFans {
  unsigned certified = 0;
  std::array<std::array<std::uint32_t, detail::kMaxFan>, 8> undecided = {};  // of the others

  friend bool operator==(const TestedFans&, const TestedFans&) = default;
};

using TestFans = TestedFans(const detail::Fans& fans, const detail::FanRun& run,
                            std::uint32_t first, std::uint32_t count,
                            const FanPositions& positions);
PELT_DECLARE_COMPILED(TestFans, test_fans)

}  // namespace pelt::test
