/// The exact test of moving triangles, and the independent one of the tests, against queries whose
/// answers others computed symbolically: all CSV files below PELT_SHARED_DIR/ccd.
#include "ccd_triangles.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <vector>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;
using detail::FirstMeeting;

std::vector<fs::path> csv_files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  constexpr auto kFollow = fs::directory_options::follow_directory_symlink;
  for (const auto& entry : fs::recursive_directory_iterator(folder, kFollow))
    if (entry.is_regular_file() && entry.path().extension() == ".csv") files.push_back(entry);
  std::sort(files.begin(), files.end());
  return files;
}

/// Counts of queries of one kind.
struct Tally {
  std::size_t files = 0, asked = 0, as_floats = 0, too_large = 0, met = 0, differences = 0;
};

std::optional<FirstMeeting> meeting_by_oracle(const CcdQuery& query, const MovingCorners& corners) {
  MovingOracle oracle(corners);
  if (query.kind == CcdKind::vertex_face) return oracle.first_meeting_of({0, 0, 0}, {3, 4, 5});
  return oracle.first_meeting_of({0, 1, 1}, {3, 4, 4});
}

bool have_equal_times(const std::optional<FirstMeeting>& p, const std::optional<FirstMeeting>& q) {
  return p.has_value() == q.has_value() &&
         (!p || (p->time == q->time && p->at_start == q->at_start));
}

/// Asks one query, by numbers of GMP, as integers if they are not too large, and as triangles of
/// floats if its coordinates are float32.
void ask(const CcdQuery& query, Tally& tally) {
  const MovingCorners corners = moving_corners(query);
  const auto expected = meeting_by_oracle(query, corners);
  ++tally.asked;
  tally.met += query.meets;
  bool is_different = expected.has_value() != query.meets;
  const auto points = moving_points(corners);
  tally.too_large += !points;
  const auto answer = points ? detail::first_meeting(*points) : expected;
  is_different |= !have_equal_times(answer, expected);
  if (const auto floats = collapsed_triangles(query)) {
    const auto& [a, b] = *floats;
    MovingStats work;
    ++tally.as_floats;
    is_different |= detail::first_meeting(a, b) != answer;
    is_different |= detail::find_first_meeting(a, b, work) != answer;
    is_different |= detail::intersect_while_moving(a, b, work) != answer.has_value();
  }
  if (!is_different) return;
  if (++tally.differences <= 5)
    ADD_FAILURE() << query.origin << ": expected " << query.meets << "; independent test "
                  << expected.has_value() << ", exact test " << answer.has_value();
}

void ask_all(const fs::path& csv, std::map<CcdKind, Tally>& tallies) {
  try {
    const std::vector<CcdQuery> queries = read_ccd_queries(csv);
    if (queries.empty()) throw CcdProblem(csv.string() + " has no queries");
    ++tallies[queries.front().kind].files;
    for (const CcdQuery& query : queries) ask(query, tallies[query.kind]);
  } catch (const CcdProblem& problem) {
    ADD_FAILURE() << problem.what();
  }
}

TEST(CcdTruth, AllQueriesBelowTheSharedFolder) {
  const fs::path folder = fs::path(PELT_SHARED_DIR) / "ccd";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  std::map<CcdKind, Tally> tallies;
  const std::vector<fs::path> files = csv_files_below(folder);
  ASSERT_FALSE(files.empty()) << "no CSV file below " << folder;
  for (const fs::path& csv : files) ask_all(csv, tallies);
  for (const auto& [kind, tally] : tallies) {
    std::cout << (kind == CcdKind::edge_edge ? "edge-edge" : "vertex-face") << ": " << tally.asked
              << " queries of " << tally.files << " files, " << tally.met << " of them meet, "
              << tally.as_floats << " also asked as floats, " << tally.too_large
              << " too large for the exact test, " << tally.differences << " differences\n";
    EXPECT_EQ(tally.differences, 0u);
  }
}

}  // namespace
}  // namespace pelt::test
