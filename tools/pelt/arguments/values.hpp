#pragma once

/// Values of options: frames, positions and instruction sets.

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include "tools/pelt/arguments/verb.hpp"

#include <array>
#include <cstdint>
#include <string>
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

/// Parses "x,y,z", each at most 1e12 from 0. Error messages name `option`.
Result<std::array<double, 3>> parse_position(const std::string& option, const std::string& text);

/// The same, rounded to float.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

/// Adds --simd, which sets `name`.
void add_simd_option(Verb& verb, std::string& name);

/// Selects the instruction set of this name for queries; "" selects the library's default.
Result<void> choose_simd(const std::string& name);

}  // namespace pelt::tools::arguments
