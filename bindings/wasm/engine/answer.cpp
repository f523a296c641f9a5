#include "bindings/wasm/engine/answer.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
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

void answer_numbers(std::initializer_list<double> numbers) {
  std::copy(numbers.begin(), numbers.end(), answer().numbers.begin());
}

void answer_stats(const QueryStats& stats) {
  answer_numbers({static_cast<double>(stats.node_pairs), static_cast<double>(stats.refits),
                  static_cast<double>(stats.posed_vertices),
                  static_cast<double>(stats.triangle_pairs),
                  static_cast<double>(stats.displacements), stats.cut_short ? 1.0 : 0.0});
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

std::uint32_t done(const Result<void>& result) { return result ? 1 : refuse(result.error()); }

PELT_EXPORT const Answer* pelt_answer() { return &answer(); }

PELT_EXPORT const char* pelt_error() {
  return answer_json({{"code", name_of(kept_error().code)}, {"message", kept_error().message}});
}

}  // namespace pelt::wasm
