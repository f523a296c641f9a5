#pragma once

#include <pelt/result.hpp>

#include "tools/pelt/arguments/verb.hpp"

#include <string>

namespace pelt::tools::arguments {

/// Adds --simd, which sets `name`.
void add_simd_option(Verb& verb, std::string& name);

/// Selects the instruction set of this name for queries; "" selects the library's default.
Result<void> choose_simd(const std::string& name);

}  // namespace pelt::tools::arguments
