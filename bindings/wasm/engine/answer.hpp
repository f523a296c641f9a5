#pragma once

/// The answer of an engine function to JavaScript, if it is more than a number. There is a single
/// answer, which the next call replaces; JavaScript is single-threaded and reads it at once.

#include <pelt/math.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>
#include <pelt/self_filter.hpp>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <iterator>
#include <string>

/// A function that JavaScript calls as it is, without export.hpp.
#define PELT_RAW_EXPORT extern "C" [[gnu::used, gnu::visibility("default")]]

namespace pelt::wasm {

/// A point, or three numbers that are read together.
using Numbers3 = std::array<double, 3>;

inline Numbers3 numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// An array that JavaScript copies.
struct AnswerArray {
  const void* data = nullptr;
  std::uint32_t bytes = 0;
};

/// Functions of the engine set some of the fields. JavaScript reads the fields by name, at the
/// places that `pelt_layout` lists.
struct Answer {
  double node_pairs = 0, refits = 0, posed_vertices = 0, triangle_pairs = 0, displacements = 0;
  double clamped_offsets = 0;
  double cut_short = 0;                      ///< 1: yes
  double double_pairs = 0, exact_pairs = 0;  ///< of queries of motions
  double distance = 0, lower_bound = 0;      ///< of two surfaces, or of a surface and a point
  double vertex = 0, depth = 0;              ///< the deepest vertex
  Numbers3 position = {};                    ///< of that vertex
  double ignored = 0;                        ///< number of ignored contacts
  std::array<double, 6> left_out = {};       ///< see LeftOut
  double hash_high = 0, hash_low = 0;        ///< the halves of a hash
  Numbers3 low = {}, high = {};              ///< a box
  Numbers3 centre = {};                      ///< a sphere
  double radius = 0;
  std::array<AnswerArray, 9> arrays = {};
};

Answer& answer();

void answer_work(const QueryStats& stats);
void answer_left_out(const LeftOut& left_out);
void answer_box(const Box& box);

/// Sets the fields of the work, and of what else the statistics have. Every query calls this, also
/// if JavaScript returns no work. A function that returns statistics need not call it.
template <typename Stats>
void answer_stats(const Stats& stats) {
  answer_work(stats);
  if constexpr (requires { stats.left_out; }) answer_left_out(stats.left_out);
  if constexpr (requires { stats.exact_pairs; }) {
    answer().double_pairs = static_cast<double>(stats.double_pairs);
    answer().exact_pairs = static_cast<double>(stats.exact_pairs);
  }
}

/// Answers with arrays, which must stay as they are until JavaScript has read them.
template <typename... Arrays>
void answer_arrays(const Arrays&... arrays) {
  answer().arrays = {
      AnswerArray{std::data(arrays),
                  static_cast<std::uint32_t>(std::size(arrays) * sizeof(*std::data(arrays)))}...};
}

/// Returns a text that stays valid until the next one.
const char* answer_text(std::string text);
const char* answer_json(const nlohmann::json& json);

/// Stores the error, which JavaScript reads next, and returns NaN.
double refuse(Error error);

/// Replaces C++ names in a message of the library with those of JavaScript.
Error in_words_of_javascript(Error error);
Result<void> in_words_of_javascript(const Result<void>& result);

}  // namespace pelt::wasm
