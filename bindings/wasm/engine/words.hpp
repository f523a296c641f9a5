#pragma once

#include <pelt/result.hpp>

namespace pelt::wasm {

/// Replaces C++ names in a message of the library with those of JavaScript.
Error in_words_of_javascript(Error error);

}  // namespace pelt::wasm
