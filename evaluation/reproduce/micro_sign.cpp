#include "evaluation/reproduce/micro_sign.hpp"

#include <cctype>

namespace pelt::reproduce {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Whether the "us" at `at` is a unit: after "[" or a number, and no part of a word.
bool is_unit(const std::string& text, std::size_t at) {
  const bool ends = at + 2 == text.size() || !is_letter(text[at + 2]);
  const bool in_brackets = at > 0 && text[at - 1] == '[';
  return ends && (in_brackets || (at > 1 && text[at - 1] == ' ' && is_digit(text[at - 2])));
}

}  // namespace

std::string with_micro_signs(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_micro = text.compare(i, 2, "us") == 0 && is_unit(text, i);
    out += is_micro ? "\u00b5" : std::string(1, text[i]);
  }
  return out;
}

}  // namespace pelt::reproduce
