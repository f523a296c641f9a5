/// Queries with known answers: tests their reader on small folders in the layouts of public
/// collections, and the tests of moving triangles on the collections themselves.

#include "exact/gmp_integers.hpp"
#include "motion/ccd_queries.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_oracle.hpp"
#include "motion/moving_pair.hpp"
#include "motion/moving_polynomials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::test {
namespace {

// Queries of collections as collapsed triangles: {v, v, v} and the face, or {a, b, b} and
// {c, d, d}.

/// The number of the query's point for each corner of the two triangles.
std::array<std::size_t, 6> points_of_corners(CcdKind kind) {
  if (kind == CcdKind::vertex_face) return {0, 0, 0, 1, 2, 3};
  return {0, 1, 1, 2, 3, 3};
}

/// The corners in units of which all coordinates on an axis are multiples, as large as possible.
MovingCorners moving_corners(const CcdQuery& query) {
  const auto points = points_of_corners(query.kind);
  MovingCorners corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    mpz_class below = 1, common;
    for (const RationalPoint& p : query.points) below = lcm(below, p[axis].get_den());
    for (const RationalPoint& p : query.points)
      common = gcd(common, mpz_class(p[axis].get_num() * (below / p[axis].get_den())));
    if (common == 0) common = 1;
    const auto coordinate = [&](std::size_t point) {
      const mpq_class& x = query.points[point][axis];
      return mpz_class(x.get_num() * (below / x.get_den()) / common);
    };
    for (std::size_t i = 0; i < 6; ++i)
      corners[i][axis] = {coordinate(points[i]), coordinate(points[i] + 4)};
  }
  return corners;
}

/// The same for the library's exact test. Nullopt if coordinates have too many bits.
std::optional<detail::MovingPoints> moving_points(const MovingCorners& corners) {
  detail::MovingPoints result;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& [from, to] = corners[i][axis];
      if (std::max(bits_of(from), bits_of(to)) > detail::kCoordinateBits) return std::nullopt;
      using Integer = decltype(detail::MovingCoordinate::from);
      result[i][axis] = {from_gmp<Integer>(from), from_gmp<Integer>(to)};
    }
  return result;
}

struct CollapsedTriangles {
  detail::MovingTriangle a, b;
};

/// Nullopt if a coordinate is not a float32, or too large for the library.
std::optional<CollapsedTriangles> collapsed_triangles(const CcdQuery& query) {
  const auto is_float = [](const mpq_class& x) {
    return abs(x) < 0x1p61 && mpq_class(static_cast<float>(x.get_d())) == x;
  };
  for (const RationalPoint& p : query.points)
    if (!std::all_of(p.begin(), p.end(), is_float)) return std::nullopt;
  const auto position = [&](std::size_t point) {
    const auto& [x, y, z] = query.points[point];
    return Vec3{static_cast<float>(x.get_d()), static_cast<float>(y.get_d()),
                static_cast<float>(z.get_d())};
  };
  const auto points = points_of_corners(query.kind);
  CollapsedTriangles result;
  for (std::size_t i = 0; i < 6; ++i) {
    detail::MovingTriangle& triangle = i < 3 ? result.a : result.b;
    triangle.from[i % 3] = position(points[i]);
    triangle.to[i % 3] = position(points[i] + 4);
  }
  return result;
}

namespace fs = std::filesystem;

/// A vertex that falls from z = 1 to z = -1 through a face, and one that rises.
constexpr std::string_view kFalls =
    "1,2,1,2,1,1\n0,1,0,1,0,1\n4,1,0,1,0,1\n0,1,4,1,0,1\n"
    "1,2,1,2,-1,1\n0,1,0,1,0,1\n4,1,0,1,0,1\n0,1,4,1,0,1\n";
constexpr std::string_view kRises =
    "1,2,1,2,1,1\n0,1,0,1,0,1\n4,1,0,1,0,1\n0,1,4,1,0,1\n"
    "1,2,1,2,2,1\n0,1,0,1,0,1\n4,1,0,1,0,1\n0,1,4,1,0,1\n";

std::string operator+(std::string_view p, std::string_view q) { return std::string(p) += q; }

/// The lines of `text`, each with `end` instead of its line end.
std::string with_line_ends(std::string_view text, std::string_view end) {
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += end;
    else
      result += c;
  return result;
}

class CcdQueries : public testing::Test {
 protected:
  CcdQueries() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / "pelt_ccd_queries_test" / test->name();
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~CcdQueries() override { fs::remove_all(root_); }

  fs::path write(const fs::path& name, std::string_view text) const {
    const fs::path path = root_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  /// Expects kFalls and kRises.
  static void expect_two_queries(const fs::path& csv) {
    const std::vector<CcdQuery> queries = read_ccd_queries(csv);
    ASSERT_EQ(queries.size(), 2u) << csv;
    EXPECT_EQ(queries[0].kind, CcdKind::vertex_face) << csv;
    EXPECT_EQ(queries[0].points[0], (RationalPoint{mpq_class(1, 2), mpq_class(1, 2), 1})) << csv;
    EXPECT_EQ(queries[0].points[6], (RationalPoint{4, 0, 0})) << csv;
    EXPECT_EQ(queries[1].points[4][2], 2) << csv;
    EXPECT_TRUE(queries[0].meets && !queries[1].meets) << csv;
  }

  static std::string problem_with(const fs::path& csv) {
    try {
      read_ccd_queries(csv);
    } catch (const CcdProblem& problem) {
      return problem.what();
    }
    return "none";
  }

  void expect_problem(std::string_view text, const std::string& problem) const {
    const fs::path csv = write("wrong_vf.csv", text);
    EXPECT_EQ(problem_with(csv), csv.string() + problem);
  }

 private:
  fs::path root_;
};

TEST_F(CcdQueries, HaveAnswersInAColumn) {
  const std::string text = with_line_ends(kFalls, ",1\n") + with_line_ends(kRises, ",0\n");
  expect_two_queries(write("scene/vertex-face/data_0_0.csv", text));
  expect_two_queries(write("deep/er/scene/VF/data_0_1.csv", with_line_ends(text, "\r\n")));
  expect_two_queries(write("scene/7vf.csv", with_line_ends(text, "\n\n") + " \r\n\n\n"));
  expect_two_queries(write("scene/ballvf.csv", "\xEF\xBB\xBF# a comment\n" + text));
  expect_two_queries(write("vertex-face/tree.csv", text));
}

TEST_F(CcdQueries, HaveAnswersInAJsonFile) {
  const std::string text = kFalls + kRises;
  write("flat/ball-18vf.json", "[true,false]\n");
  expect_two_queries(write("flat/ball-18vf.csv", text));
  write("ball/boxes/18vf.json", "[[1, 2], [1, 3]]");
  write("ball/mma_bool/18vf_mma_bool.json", "[\n  true,\n  false\n]\n");
  expect_two_queries(write("ball/queries/18vf.csv", text));
  write("rod/queries/mma_bool/18vf.json", "[1, 0]");
  expect_two_queries(write("rod/queries/18vf.csv", text));
  write("split/mma_bool/vertex-face/data_0_0.json", "[true, false]");
  expect_two_queries(write("split/queries/vertex-face/data_0_0.csv", text));
  write("truth/answers/18vf.json", "[true, false]");
  expect_two_queries(write("truth/rows/18vf.csv", text));
}

TEST_F(CcdQueries, AreNumbersOfAnyLength) {
  const std::string many_digits(400, '1');
  const std::vector<CcdQuery> queries = read_ccd_queries(
      write("long_vf.csv", with_line_ends(with_line_ends(kFalls, ",1\n"), "\n") +
                               with_line_ends("1," + many_digits + ",-" + many_digits +
                                                  ",3,4,-8\n" + std::string(kRises).substr(12),
                                              ",0\n")));
  ASSERT_EQ(queries.size(), 2u);
  const auto& [x, y, z] = queries[1].points[0];
  EXPECT_EQ(x * mpz_class(many_digits), 1);
  EXPECT_EQ(-3 * y, mpz_class(many_digits));
  EXPECT_EQ(2 * z, -1);
  EXPECT_TRUE(moving_points(moving_corners(queries[0])));
  EXPECT_FALSE(moving_points(moving_corners(queries[1])));
  EXPECT_TRUE(collapsed_triangles(queries[0]));
  EXPECT_FALSE(collapsed_triangles(queries[1]));
}

TEST_F(CcdQueries, MayBeDecimals) {
  const fs::path csv = write("decimals_ee.csv",
                             "0.5,-1,1e-3,true\n0.5,1,1e-3,true\n0.1,0,0,true\n1,0,0,true\n"
                             "0.5,-1,-1e-3,true\n0.5,1,-1e-3,true\n0.1,0,0,true\n1,0,0,true\n");
  const std::vector<CcdQuery> queries = read_ccd_queries(csv);
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].kind, CcdKind::edge_edge);
  EXPECT_EQ(queries[0].points[0][2], mpq_class(1e-3));
  EXPECT_FALSE(collapsed_triangles(queries[0]));  // 0.1 is a double
  const auto meeting = detail::first_meeting(*moving_points(moving_corners(queries[0])));
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->time, 0.5f);
}

TEST_F(CcdQueries, AreRefusedWithFileAndLine) {
  const std::string good = with_line_ends(kFalls, ",1\n");
  expect_problem(good + "\n1,2,3\n", ", line 10: the last query has fewer than eight rows");
  expect_problem(good + "1,2,3,4,5\n", ", line 9: has 5 columns instead of 6 or 7, or 3 or 4");
  expect_problem("1,2,x,4,5,6\n", ", line 1: expected a number, not 'x'");
  expect_problem("1,2,3,4,5,nan\n", ", line 1: expected a number, not 'nan'");
  expect_problem("#\n1,0,3,4,5,6\n", ", line 2: the denominator is 0");
  expect_problem("1,2,3,4,5,6,2\n", ", line 1: expected the answer 0 or 1, not '2'");
  expect_problem("1,2,3,4,5,6,1\n1,2,3,4,5,6,0\n",
                 ", line 2: has another answer than the row above");
  expect_problem(good + kRises, ", line 16: some rows above have an answer, and others have none");
  expect_problem(kFalls,
                 " has no column with answers, and no file wrong_vf.json or "
                 "wrong_vf_mma_bool.json has them");
  write("wrong_vf.json", "[true, true]");
  expect_problem(kFalls, " has 1 queries, but its JSON file has 2 answers");
}

TEST_F(CcdQueries, AreRefusedWithoutAFileOrAKind) {
  const fs::path missing = write("vf/there.csv", "").parent_path() / "missing.csv";
  EXPECT_EQ(problem_with(missing), missing.string() + " cannot be read");
  const fs::path neither = write("scene/data.csv", kFalls);
  EXPECT_EQ(problem_with(neither),
            neither.string() +
                " is neither edge-edge nor vertex-face by the names of the file and its folders");
}

// The exact test of moving triangles, and the independent one of the tests, against queries whose
// answers others computed symbolically: all CSV files below PELT_SHARED_DIR/ccd.

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
