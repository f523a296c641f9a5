#pragma once

/// How a function of the engine tells JavaScript more than one number. There is one answer, which
/// the next call replaces: JavaScript is one thread, and takes what it wants at once.

#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

/// A function that JavaScript calls.
#define PELT_EXPORT extern "C" [[gnu::used, gnu::visibility("default")]]

namespace pelt::wasm {

/// JavaScript reads it by its layout (memory.mjs).
struct Answer {
  std::array<double, 16> numbers = {};
  const void* data = nullptr;
  std::uint32_t count = 0;  ///< elements of `data`
};
static_assert(offsetof(Answer, data) == 16 * sizeof(double) && sizeof(void*) == 4 &&
                  offsetof(Answer, count) == offsetof(Answer, data) + 4,
              "JavaScript reads 16 numbers, then two of 32 bits");

Answer& answer();

void answer_numbers(std::initializer_list<double> numbers);

/// Into the numbers 0 to 5.
void answer_stats(const QueryStats& stats);

template <typename T>
void answer_data(std::span<const T> elements) {
  answer().data = elements.data();
  answer().count = static_cast<std::uint32_t>(elements.size());
}

/// Text that stays until the next one.
const char* answer_text(std::string text);
const char* answer_json(const nlohmann::json& json);

/// 0, for a handle or a yes, after which JavaScript asks for the error.
std::uint32_t refuse(Error error);

/// 1, or as above.
std::uint32_t done(const Result<void>& result);

}  // namespace pelt::wasm
