#include "scenes/nearest_name.hpp"

#include "asset/message.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pelt::scenes {
namespace {

/// Levenshtein's distance: the fewest characters inserted, removed or replaced.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string listed(std::span<const std::string_view> names) {
  constexpr std::size_t kMostShown = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostShown); ++i) {
    text += (i == 0 ? "" : ", ") + asset::quoted(names[i]);
  }
  return names.size() > kMostShown ? text + " ..." : text;
}

}  // namespace

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestTypo = 64, kMostErrors = 2;
  std::size_t fewest = kMostErrors + 1;
  std::string_view nearest;
  for (const std::string_view candidate : known) {
    if (name.size() > kLongestTypo || candidate.size() <= kMostErrors) continue;
    const std::size_t errors = edit_distance(name, candidate);
    if (errors >= fewest) continue;
    fewest = errors;
    nearest = candidate;
  }
  if (!nearest.empty()) return ", did you mean " + asset::quoted(nearest) + "?";
  return ", expected one of " + listed(known);
}

}  // namespace pelt::scenes
