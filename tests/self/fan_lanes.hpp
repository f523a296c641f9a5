#pragma once

#include "self/flat_fans.hpp"

#include <pelt/instruction_set.hpp>

namespace pelt::test {

using FanPositions = std::vector<std::array<float, 4>>;

/// The certificate of up to eight fans, as compiled for each instruction set.
namespace avx2 {
unsigned flat_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                   std::uint32_t count, const FanPositions& positions);
}
namespace simd128 {
unsigned flat_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                   std::uint32_t count, const FanPositions& positions);
}
namespace scalar {
unsigned flat_fans(const detail::Fans& fans, const detail::FanRun& run, std::uint32_t first,
                   std::uint32_t count, const FanPositions& positions);
}

}  // namespace pelt::test
