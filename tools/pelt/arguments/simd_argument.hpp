#pragma once

#include <pelt/result.hpp>

#include "tools/pelt/arguments/verb.hpp"

#include <string>

namespace pelt::tools::arguments {

/// Adds --simd, whose value goes to `name`.
void add_simd_option(Verb& verb, std::string& name);

/// Lets queries use the instructions of that name; "" leaves the choice to the library.
Result<void> choose_simd(const std::string& name);

}  // namespace pelt::tools::arguments
