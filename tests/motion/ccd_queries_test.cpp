/// The reader of collections of queries, on small folders in the layouts of public collections.
#include "ccd_answers.hpp"
#include "ccd_triangles.hpp"
#include "motion/moving_pair.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace pelt::test {
namespace {

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

}  // namespace
}  // namespace pelt::test
