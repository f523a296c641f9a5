#pragma once

/// The answer of an engine function to JavaScript, if it is more than a number. There is a single
/// answer, which the next call replaces; JavaScript is single-threaded and reads it at once.

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

/// JavaScript depends on this layout (memory.mjs).
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

/// Writes the stats to the numbers 0 to 5.
void answer_stats(const QueryStats& stats);

template <typename T>
void answer_data(std::span<const T> elements) {
  answer().data = elements.data();
  answer().count = static_cast<std::uint32_t>(elements.size());
}

/// Returns a text that stays valid until the next one.
const char* answer_text(std::string text);
const char* answer_json(const nlohmann::json& json);

/// Stores the error, which JavaScript reads next, and returns 0.
std::uint32_t refuse(Error error);

/// Returns 1, or `refuse` of the error.
std::uint32_t done(const Result<void>& result);

}  // namespace pelt::wasm
