#include "ccd_queries.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;
using Numerator = decltype(BinaryFraction::numerator);

constexpr std::size_t kRows = 8, kColumns = 6;

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw CcdProblem(where + ": " + problem);
}

Numerator integer(std::string_view text, const std::string& where) {
  const bool is_negative = !text.empty() && text.front() == '-';
  if (is_negative) text.remove_prefix(1);
  if (text.empty() || text.size() > 360) fail(where, "expected an integer of 1 to 360 digits");
  Numerator result;
  for (const char c : text) {
    if (c < '0' || c > '9') fail(where, "expected an integer, not '" + std::string(text) + "'");
    result = result * Numerator(10) + Numerator(c - '0');
  }
  if (is_negative) result.negate();
  return result;
}

BinaryFraction fraction(std::string_view numerator, std::string_view denominator,
                        const std::string& where) {
  const Numerator below = integer(denominator, where);
  if (below.sign() <= 0 || below.bits() != below.trailing_zeros() + 1)
    fail(where, "the denominator " + std::string(denominator) + " is not a power of two");
  BinaryFraction result = {integer(numerator, where), below.trailing_zeros()};
  if (result.numerator.sign() == 0) return {};
  const unsigned common = std::min(result.numerator.trailing_zeros(), result.exponent);
  result.numerator >>= common;
  result.exponent -= common;
  return result;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    std::erase_if(field, [](unsigned char c) { return std::isspace(c) != 0; });
    fields.push_back(field);
  }
  return fields;
}

CcdKind kind_of(const fs::path& csv) {
  const auto is_below = [&](const char* folder) {
    return std::find(csv.begin(), csv.end(), folder) != csv.end();
  };
  const std::string stem = csv.stem().string();
  if (is_below("edge-edge") || stem.ends_with("ee")) return CcdKind::edge_edge;
  if (is_below("vertex-face") || stem.ends_with("vf")) return CcdKind::vertex_face;
  fail(csv.string(), "neither edge-edge nor vertex-face by the names of the file and its folders");
}

/// The words `true` and `false` of a file, in order.
std::vector<bool> answers_in(const fs::path& json) {
  std::ifstream stream(json);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<bool> answers;
  for (std::size_t at = 0; (at = text.find_first_of("tf", at)) != std::string::npos; ++at) {
    if (text.compare(at, 4, "true") == 0) answers.push_back(true);
    if (text.compare(at, 5, "false") == 0) answers.push_back(false);
  }
  return answers;
}

std::vector<bool> answers_beside(const fs::path& csv) {
  const fs::path name = csv.stem().string() + "_mma_bool.json";
  fs::path same_name = csv;
  same_name.replace_extension(".json");
  for (const fs::path& json :
       {same_name, csv.parent_path() / name, csv.parent_path().parent_path() / "mma_bool" / name})
    if (fs::exists(json)) return answers_in(json);
  fail(csv.string(), "has no seventh column with answers, and there is no " + same_name.string());
}

class Reader {
 public:
  explicit Reader(const fs::path& csv) : csv_(csv), kind_(kind_of(csv)) {}

  std::vector<CcdQuery> read() {
    std::ifstream stream(csv_);
    if (!stream) fail(csv_.string(), "cannot be read");
    for (std::string line; std::getline(stream, line);)
      if (line.find_first_not_of(" \r\t") != std::string::npos) add_row(fields_of(line));
    if (rows_ % kRows != 0) fail(where(), "the last query has fewer than eight rows");
    if (!has_answers_) add_answers(answers_beside(csv_));
    return std::move(queries_);
  }

 private:
  std::string where() const { return csv_.string() + ", row " + std::to_string(rows_); }

  void add_row(const std::vector<std::string>& fields) {
    const std::size_t row = rows_++ % kRows;
    if (fields.size() != kColumns && fields.size() != kColumns + 1)
      fail(where(), "has " + std::to_string(fields.size()) + " columns instead of 6 or 7");
    if (row == 0) {
      queries_.emplace_back();
      queries_.back().origin = csv_.string() + ", query " + std::to_string(queries_.size());
      queries_.back().kind = kind_;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      queries_.back().points[row][axis] = fraction(fields[2 * axis], fields[2 * axis + 1], where());
    if (fields.size() == kColumns) return;
    const std::string& answer = fields[kColumns];
    if (answer != "0" && answer != "1") fail(where(), "the answer is neither 0 nor 1");
    if (row != 0 && queries_.back().meets != (answer == "1")) fail(where(), "has another answer");
    queries_.back().meets = answer == "1";
    has_answers_ = true;
  }

  void add_answers(const std::vector<bool>& answers) {
    if (answers.size() != queries_.size())
      fail(csv_.string(), "has " + std::to_string(queries_.size()) + " queries, but " +
                              std::to_string(answers.size()) + " answers");
    for (std::size_t i = 0; i < answers.size(); ++i) queries_[i].meets = answers[i];
  }

  fs::path csv_;
  CcdKind kind_;
  std::vector<CcdQuery> queries_;
  std::size_t rows_ = 0;
  bool has_answers_ = false;
};

/// The number of the query's point for each corner of the two triangles.
std::array<std::size_t, 6> corners_of(CcdKind kind) {
  if (kind == CcdKind::vertex_face) return {0, 0, 0, 1, 2, 3};
  return {0, 1, 1, 2, 3, 3};
}

float to_float(const BinaryFraction& number) {
  return static_cast<float>(
      std::ldexp(rounded(number.numerator), -static_cast<int>(number.exponent)));
}

/// Whether the number is a float32 of the library's range.
bool is_float(const BinaryFraction& number) {
  if (number.numerator.sign() == 0) return true;
  const unsigned zeros = number.numerator.trailing_zeros(), bits = number.numerator.bits();
  return bits - zeros <= 24 && number.exponent <= 149 && bits < 61 + number.exponent;
}

}  // namespace

std::vector<CcdQuery> read_ccd_queries(const fs::path& csv) { return Reader(csv).read(); }

detail::MovingPoints collapsed_triangles(const CcdQuery& query) {
  detail::MovingPoints result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    unsigned unit = 0;
    for (const auto& point : query.points) unit = std::max(unit, point[axis].exponent);
    const auto coordinate = [&](std::size_t point) {
      const BinaryFraction& number = query.points[point][axis];
      const unsigned shift = unit - number.exponent;
      if (number.numerator.bits() + shift > detail::kCoordinateBits)
        fail(query.origin, "coordinates of more than " + std::to_string(detail::kCoordinateBits) +
                               " bits in a common unit");
      return detail::BigInteger<detail::kCoordinateBits>(number.numerator) << shift;
    };
    const auto corners = corners_of(query.kind);
    for (std::size_t i = 0; i < 6; ++i)
      result[i][axis] = {coordinate(corners[i]), coordinate(corners[i] + 4)};
  }
  return result;
}

bool collapsed_triangles(const CcdQuery& query, detail::MovingTriangle& a,
                         detail::MovingTriangle& b) {
  for (const auto& point : query.points)
    if (!std::all_of(point.begin(), point.end(), is_float)) return false;
  const auto position = [&](std::size_t point) {
    const auto& [x, y, z] = query.points[point];
    return Vec3{to_float(x), to_float(y), to_float(z)};
  };
  const auto corners = corners_of(query.kind);
  for (std::size_t i = 0; i < 6; ++i) {
    detail::MovingTriangle& triangle = i < 3 ? a : b;
    triangle.from[i % 3] = position(corners[i]);
    triangle.to[i % 3] = position(corners[i] + 4);
  }
  return true;
}

}  // namespace pelt::test
