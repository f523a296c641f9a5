#include "bindings/wasm/engine/answer.hpp"

#include <pelt/version.hpp>

#include "bindings/wasm/engine/export.hpp"

#include <nlohmann/json.hpp>

#include <malloc.h>

#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace pelt::wasm {
namespace {

std::string& kept_text() {
  static std::string text;
  return text;
}

Error& kept_error() {
  static Error error;
  return error;
}

/// A field of Answer: its name in JavaScript, its place in bytes, and its number of doubles.
struct Field {
  const char* name;
  std::size_t offset, doubles;
};

constexpr Field kFields[] = {
    {"nodePairs", offsetof(Answer, node_pairs), 1},
    {"refits", offsetof(Answer, refits), 1},
    {"posedVertices", offsetof(Answer, posed_vertices), 1},
    {"trianglePairs", offsetof(Answer, triangle_pairs), 1},
    {"displacements", offsetof(Answer, displacements), 1},
    {"clampedOffsets", offsetof(Answer, clamped_offsets), 1},
    {"cutShort", offsetof(Answer, cut_short), 1},
    {"doublePairs", offsetof(Answer, double_pairs), 1},
    {"exactPairs", offsetof(Answer, exact_pairs), 1},
    {"distance", offsetof(Answer, distance), 1},
    {"lowerBound", offsetof(Answer, lower_bound), 1},
    {"vertex", offsetof(Answer, vertex), 1},
    {"depth", offsetof(Answer, depth), 1},
    {"position", offsetof(Answer, position), 3},
    {"ignored", offsetof(Answer, ignored), 1},
    {"leftOut", offsetof(Answer, left_out), 6},
    {"hashHigh", offsetof(Answer, hash_high), 1},
    {"hashLow", offsetof(Answer, hash_low), 1},
    {"low", offsetof(Answer, low), 3},
    {"high", offsetof(Answer, high), 3},
    {"centre", offsetof(Answer, centre), 3},
    {"radius", offsetof(Answer, radius), 1},
};
static_assert(sizeof(void*) == 4 && sizeof(AnswerArray) == 8,
              "JavaScript reads an array's data and bytes as two numbers of 32 bits");

/// Memory where JavaScript writes arguments, and behind them copies of small arrays and texts.
alignas(16) std::array<double, 8192> input;

struct Words {
  std::string_view in_code, in_javascript;
};

/// A phrase comes before those that it contains.
constexpr Words kWords[] = {
    {"off_weights = OffWeights::renormalise", "renormalise: true"},
    {"ModelOptions::weld = false", "weld: false"},
    {"ModelOptions::skinning = Skinning::dual_quaternion", "skinning: 'dual-quaternion'"},
    {"dual_quaternions[", "dualQuaternions["},
    {"SkinnedMeshView::offset_caps", "offsetCaps"},
    {"offset_caps", "offsetCaps"},
    {"rest_positions", "restPositions"},
    {"set_palette", "setPalette"},
};

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return "invalid_argument";
    case ErrorCode::unreadable_file:
      return "unreadable_file";
    case ErrorCode::malformed_file:
      return "malformed_file";
    case ErrorCode::unsupported:
      return "unsupported";
  }
  return "";
}

}  // namespace

Answer& answer() {
  static Answer answer;
  return answer;
}

void answer_work(const QueryStats& stats) {
  Answer& answered = answer();
  answered.node_pairs = static_cast<double>(stats.node_pairs);
  answered.refits = static_cast<double>(stats.refits);
  answered.posed_vertices = static_cast<double>(stats.posed_vertices);
  answered.triangle_pairs = static_cast<double>(stats.triangle_pairs);
  answered.displacements = static_cast<double>(stats.displacements);
  answered.clamped_offsets = static_cast<double>(stats.clamped_offsets);
  answered.cut_short = stats.cut_short ? 1 : 0;
}

void answer_left_out(const LeftOut& left_out) {
  const auto number = [](std::uint64_t count) { return static_cast<double>(count); };
  answer().left_out = {number(left_out.takes_part), number(left_out.rings),
                       number(left_out.at_rest),    number(left_out.always),
                       number(left_out.joints),     number(left_out.groups)};
}

void answer_box(const Box& box) {
  answer().low = numbers_of(box.low);
  answer().high = numbers_of(box.high);
}

const char* answer_text(std::string text) {
  kept_text() = std::move(text);
  return kept_text().c_str();
}

const char* answer_json(const nlohmann::json& json) {
  return answer_text(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

double refuse(Error error) {
  kept_error() = std::move(error);
  return std::numeric_limits<double>::quiet_NaN();
}

Error in_words_of_javascript(Error error) {
  for (const auto& [in_code, in_javascript] : kWords)
    if (const std::size_t at = error.message.find(in_code); at != error.message.npos)
      error.message.replace(at, in_code.size(), in_javascript);
  return error;
}

Result<void> in_words_of_javascript(const Result<void>& result) {
  if (result) return result;
  return in_words_of_javascript(result.error());
}

const double* arguments() { return input.data(); }

std::uint32_t next_whole(const double*& next) { return static_cast<std::uint32_t>(*next++); }

/// JSON: the places of the answer and its fields, in bytes, with their numbers of doubles, and
/// where JavaScript writes arguments.
PELT_RAW_EXPORT const char* pelt_layout() {
  nlohmann::json fields = nlohmann::json::object();
  for (const auto& [name, offset, doubles] : kFields) fields[name] = {offset, doubles};
  const auto place = [](const void* at) { return reinterpret_cast<std::uintptr_t>(at); };
  return answer_json({{"answer", place(&answer())},
                      {"fields", std::move(fields)},
                      {"arrays", offsetof(Answer, arrays)},
                      {"input", place(input.data())},
                      {"inputBytes", sizeof(input)}});
}

PELT_RAW_EXPORT const char* pelt_error() {
  return answer_json({{"code", name_of(kept_error().code)}, {"message", kept_error().message}});
}

const char* version() { return PELT_VERSION; }
PELT_EXPORT(version)

std::uint32_t bytes_in_use() { return static_cast<std::uint32_t>(mallinfo().uordblks); }
PELT_EXPORT(bytes_in_use)

}  // namespace pelt::wasm
