#pragma once

#include <pelt/math.hpp>
#include <pelt/result.hpp>

#include <array>
#include <string>

namespace pelt::tools::arguments {

/// Parses "x,y,z", each at most 1e12 from 0. Error messages name `option`.
Result<std::array<double, 3>> parse_position(const std::string& option, const std::string& text);

/// The same, rounded to float.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

}  // namespace pelt::tools::arguments
