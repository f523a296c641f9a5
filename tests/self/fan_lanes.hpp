#pragma once

#include "self/flat_fans.hpp"

#include <pelt/config.hpp>

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

// The same function, compiled for each instruction set.
namespace avx2 {
TestedFans test_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                     std::uint32_t count, const FanPositions& positions);
}
namespace simd128 {
TestedFans test_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                     std::uint32_t count, const FanPositions& positions);
}
namespace scalar {
TestedFans test_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                     std::uint32_t count, const FanPositions& positions);
}

}  // namespace pelt::test
