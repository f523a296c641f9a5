#pragma once

#include <pelt/result.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace pelt::tools::arguments {

/// Frames begin, begin + stride, ... below end. Never empty.
struct FrameRange {
  std::uint32_t begin = 0, end = 1, stride = 1;

  std::vector<std::uint32_t> frames() const;

  friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// "A:B" or "A:B:S", half-open.
Result<FrameRange> parse_frame_range(std::string_view text);

}  // namespace pelt::tools::arguments
