/// The exact test of moving triangles against queries whose answers others computed symbolically.
#include "ccd_queries.hpp"
#include "geometry/moving_filter.hpp"
#include "geometry/moving_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> csv_files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".csv") files.push_back(entry);
  std::sort(files.begin(), files.end());
  return files;
}

/// Counts of queries of one kind.
struct Tally {
  std::size_t files = 0, asked = 0, as_floats = 0, met = 0, differences = 0;
};

/// Asks one query, as integers and, where its coordinates are float32, as triangles of floats.
void ask(const CcdQuery& query, Tally& tally) {
  const auto answer = detail::first_meeting(collapsed_triangles(query));
  ++tally.asked;
  tally.met += query.meets;
  bool is_different = answer.has_value() != query.meets;
  detail::MovingTriangle a, b;
  if (collapsed_triangles(query, a, b)) {
    ++tally.as_floats;
    is_different |= detail::first_meeting(a, b) != answer;
    is_different |= detail::filtered_first_meeting(a, b) != answer;
    is_different |= detail::moving_triangles_intersect(a, b) != answer.has_value();
  }
  if (!is_different) return;
  if (++tally.differences <= 5) ADD_FAILURE() << query.origin << ": expected " << query.meets;
}

TEST(CcdTruth, AllQueriesBelowTheSharedFolder) {
  const fs::path folder = fs::path(PELT_SHARED_DIR) / "ccd";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  std::map<CcdKind, Tally> tallies;
  const std::vector<fs::path> files = csv_files_below(folder);
  ASSERT_FALSE(files.empty()) << "no CSV file below " << folder;
  try {
    for (const fs::path& csv : files) {
      const std::vector<CcdQuery> queries = read_ccd_queries(csv);
      ASSERT_FALSE(queries.empty()) << csv << " has no queries";
      ++tallies[queries.front().kind].files;
      for (const CcdQuery& query : queries) ask(query, tallies[query.kind]);
    }
  } catch (const CcdProblem& problem) {
    FAIL() << problem.what();
  }
  for (const auto& [kind, tally] : tallies) {
    std::cout << (kind == CcdKind::edge_edge ? "edge-edge" : "vertex-face") << ": " << tally.asked
              << " queries of " << tally.files << " files, " << tally.met << " of them meet, "
              << tally.as_floats << " also asked as floats, " << tally.differences
              << " differences\n";
    EXPECT_EQ(tally.differences, 0u);
  }
}

}  // namespace
}  // namespace pelt::test
