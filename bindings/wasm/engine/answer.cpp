#include "bindings/wasm/engine/answer.hpp"

#include "bindings/wasm/engine/words.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
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
    {"insideCount", offsetof(Answer, inside_count), 1},
    {"instance", offsetof(Answer, instance), 1},
    {"ignored", offsetof(Answer, ignored), 1},
    {"leftOut", offsetof(Answer, left_out), 6},
    {"hashHigh", offsetof(Answer, hash_high), 1},
    {"hashLow", offsetof(Answer, hash_low), 1},
    {"low", offsetof(Answer, low), 3},
    {"high", offsetof(Answer, high), 3},
    {"centre", offsetof(Answer, centre), 3},
    {"radius", offsetof(Answer, radius), 1},
};
static_assert(sizeof(void*) == 4 && offsetof(Answer, count) == offsetof(Answer, data) + 4,
              "JavaScript reads data and count as two numbers of 32 bits");

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

void answer_stats(const QueryStats& stats) {
  Answer& answered = answer();
  answered.node_pairs = static_cast<double>(stats.node_pairs);
  answered.refits = static_cast<double>(stats.refits);
  answered.posed_vertices = static_cast<double>(stats.posed_vertices);
  answered.triangle_pairs = static_cast<double>(stats.triangle_pairs);
  answered.displacements = static_cast<double>(stats.displacements);
  answered.clamped_offsets = static_cast<double>(stats.clamped_offsets);
  answered.cut_short = stats.cut_short ? 1 : 0;
}

std::uint32_t answer_yes_no(const YesNo& yes_no) {
  answer_stats(yes_no);
  return yes_no ? 1 : 0;
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

std::uint32_t refuse(Error error) {
  kept_error() = std::move(error);
  return 0;
}

std::uint32_t done(const Result<void>& result) {
  return result ? 1 : refuse(in_words_of_javascript(result.error()));
}

PELT_EXPORT const Answer* pelt_answer() { return &answer(); }

/// JSON: the place in bytes and the number of doubles of each field, and the place of the data.
PELT_EXPORT const char* pelt_answer_layout() {
  nlohmann::json fields = nlohmann::json::object();
  for (const auto& [name, offset, doubles] : kFields) fields[name] = {offset, doubles};
  return answer_json({{"fields", std::move(fields)}, {"data", offsetof(Answer, data)}});
}

PELT_EXPORT const char* pelt_error() {
  return answer_json({{"code", name_of(kept_error().code)}, {"message", kept_error().message}});
}

}  // namespace pelt::wasm
