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
#include <span>
#include <string>

/// A function that JavaScript calls.
#define PELT_EXPORT extern "C" [[gnu::used, gnu::visibility("default")]]

namespace pelt::wasm {

/// A point, or three numbers that are read together.
using Numbers3 = std::array<double, 3>;

inline Numbers3 numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Functions of the engine set some of the fields. JavaScript reads the fields by name, at the
/// places that `pelt_answer_layout` lists.
struct Answer {
  double node_pairs = 0, refits = 0, posed_vertices = 0, triangle_pairs = 0, displacements = 0;
  double clamped_offsets = 0;
  double cut_short = 0;                      ///< 1: yes
  double double_pairs = 0, exact_pairs = 0;  ///< of queries of motions
  double distance = 0, lower_bound = 0;      ///< of two surfaces, or of a surface and a point
  double vertex = 0, depth = 0;              ///< the deepest vertex
  Numbers3 position = {};                    ///< of that vertex
  double inside_count = 0;                   ///< number of triangles inside
  double instance = 0;                       ///< number of an instance of a crowd
  double ignored = 0;                        ///< number of ignored contacts
  std::array<double, 6> left_out = {};       ///< see LeftOut
  double hash_high = 0, hash_low = 0;        ///< the halves of a hash
  Numbers3 low = {}, high = {};              ///< a box
  Numbers3 centre = {};                      ///< a sphere
  double radius = 0;
  const void* data = nullptr;
  std::uint32_t count = 0;  ///< elements of `data`
};

Answer& answer();

/// Sets the fields of the work. Every query calls this, also if JavaScript returns no work.
void answer_stats(const QueryStats& stats);

/// Sets the fields of the work. Returns 1 for yes, 0 for no.
std::uint32_t answer_yes_no(const YesNo& yes_no);

void answer_left_out(const LeftOut& left_out);
void answer_box(const Box& box);

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

/// Returns 1, or `refuse` of the library's error, in words of JavaScript.
std::uint32_t done(const Result<void>& result);

}  // namespace pelt::wasm
