#include "text/message.hpp"

#include "text/printable.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pelt::text {
namespace {

/// Returns the least number of insertions, deletions, replacements and swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), above, second_above;
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    second_above = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], second_above[j - 2] + 1);
    }
  }
  return row.back();
}

std::string in_lower_case(std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns the known name with the fewest typing errors.
std::optional<std::string_view> closest_by_errors(std::string_view name,
                                                  std::span<const std::string_view> known) {
  constexpr std::size_t kLongestTypo = 64, kShortest = 3;
  const std::string wanted = in_lower_case(name);
  std::size_t fewest = std::max(std::size_t{1}, name.size() / 3) + 1;
  std::optional<std::string_view> closest;
  for (const std::string_view candidate : known) {
    if (name.size() > kLongestTypo || candidate.size() < kShortest) continue;
    const std::size_t errors = edit_distance(wanted, in_lower_case(candidate));
    if (errors >= fewest) continue;
    fewest = errors;
    closest = candidate;
  }
  return closest;
}

/// Returns the shortest known name that contains `name`.
std::optional<std::string_view> closest_around(std::string_view name,
                                               std::span<const std::string_view> known) {
  constexpr std::size_t kShortest = 3;
  if (name.size() < kShortest) return std::nullopt;
  const std::string wanted = in_lower_case(name);
  std::optional<std::string_view> closest;
  for (const std::string_view candidate : known) {
    const bool is_around = in_lower_case(candidate).find(wanted) != std::string::npos;
    if (is_around && (!closest || candidate.size() < closest->size())) closest = candidate;
  }
  return closest;
}

std::string listed(std::span<const std::string_view> names) {
  constexpr std::size_t kMaxShown = 16;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxShown); ++i) {
    text += (i == 0 ? "" : ", ") + quoted(names[i]);
  }
  if (names.size() <= kMaxShown) return text;
  return text + " and " + std::to_string(names.size() - kMaxShown) + " more";
}

}  // namespace

std::string quoted(std::string_view name) { return '"' + printable_name(name) + '"'; }

std::string label(std::string_view kind, std::size_t index, std::string_view name) {
  std::string text = std::string(kind) + " " + std::to_string(index);
  return name.empty() ? text : text + " " + quoted(name);
}

Error prefixed(std::string_view place, const Error& error) {
  return {error.code, std::string(place) + ": " + error.message};
}

std::optional<std::string_view> closest_name(std::string_view name,
                                             std::span<const std::string_view> known) {
  const auto closest = closest_by_errors(name, known);
  return closest ? closest : closest_around(name, known);
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  if (const auto closest = closest_name(name, known))
    return ", did you mean " + quoted(*closest) + "?";
  return ", expected one of " + listed(known);
}

}  // namespace pelt::text
