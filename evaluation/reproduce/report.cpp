#include "evaluation/reproduce/report.hpp"

#include "base/assert.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace pelt::reproduce {

std::size_t column_of(const Table& table, const std::string& key) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.key == key; });
  PELT_ASSERT(found != table.columns.end());
  return static_cast<std::size_t>(found - table.columns.begin());
}

double figure_at(const Table& table, std::size_t row, const std::string& key) {
  const Cell& cell = table.rows[row][column_of(table, key)];
  PELT_ASSERT(cell.figure);
  return *cell.figure;
}

std::string range_of(const Table& table, const std::string& key) {
  double least = figure_at(table, 0, key), most = least;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    least = std::min(least, figure_at(table, row, key));
    most = std::max(most, figure_at(table, row, key));
  }
  return shown(least) + " to " + shown(most);
}

/// Whole numbers in full, others with at least three digits.
std::string shown(double figure) {
  const double size = std::fabs(figure);
  if (size >= 100 || figure == std::floor(figure))
    return (figure < 0 ? "-" : "") + text::with_commas(static_cast<std::uint64_t>(size + 0.5));
  int decimals = 2;
  for (double digit = 1; digit > 1e-6 && size < digit; digit /= 10) ++decimals;
  return text::fixed(figure, size >= 10 ? 1 : decimals);
}

std::string shown(const Cell& cell) { return cell.figure ? shown(*cell.figure) : cell.name; }

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

namespace {

constexpr std::array kExperiments = {
    Experiment{"characters", "The characters (Table 1)", characters},
    Experiment{"sphere_trees", "The trees (section 5, section 3.1's constant)", sphere_trees},
    Experiment{"tightness", "How tight refitted bounds are (Table 2, Figure 4)", tightness},
    Experiment{"refit_cost", "The cost of a refit (sections 4.2 and 5)", refit_cost},
    Experiment{"two_men", "Two men walk towards each other (Figure 5)", two_men},
    Experiment{"worst_case", "Two creatures walk through each other (Figure 6)", worst_case},
    Experiment{"subdivision", "Dwarves, subdivided (Table 3, Figure 7)", subdivision},
    Experiment{"crowd", "A crowd of fifty creatures (Figure 1)", crowd_of_fifty},
    Experiment{"real_pairs", "Intersecting real characters", real_pairs},
    Experiment{"growth", "How queries grow", growth},
    Experiment{"self_collision", "Characters against themselves", self_collision},
    Experiment{"between_frames", "Between frames", between_frames},
    Experiment{"comparison", "The open comparison: trees, hashing, image space", comparison},
};

}  // namespace

std::span<const Experiment> experiments() { return kExperiments; }

const Experiment* peers_experiment() {
#ifdef PELT_HAS_PEERS
  static constexpr Experiment kPeers = {"peers", "Other libraries", peers};
  return &kPeers;
#else
  return nullptr;
#endif
}

}  // namespace pelt::reproduce
