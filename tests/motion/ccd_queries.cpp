#include "ccd_queries.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRows = 8;

/// An integer of any length, or a number that is then rounded to a double.
std::optional<mpq_class> number(const std::string& text) {
  if (text.find_first_not_of("0123456789", text.starts_with('-')) == std::string::npos) {
    mpz_class integer;
    if (integer.set_str(text, 10) != 0) return std::nullopt;
    return integer;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || !std::isfinite(value)) return std::nullopt;
  return mpq_class(value);
}

/// The text between commas, without spaces and line ends.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') fields.emplace_back();
    if (c != ',' && std::isspace(static_cast<unsigned char>(c)) == 0) fields.back() += c;
  }
  if (fields.back().empty()) fields.pop_back();
  return fields;
}

class Reader {
 public:
  explicit Reader(const fs::path& csv) : csv_(csv), kind_(ccd_kind_of(csv)) {}

  std::vector<CcdQuery> read() {
    std::ifstream stream(csv_);
    if (!stream) throw CcdProblem(csv_.string() + " cannot be read");
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
      const std::vector<std::string> fields = fields_of(line);
      if (!fields.empty() && !fields.front().starts_with('#')) add_row(fields);
    }
    if (stream.bad()) fail("cannot be read any further");
    if (rows_ % kRows != 0) fail("the last query has fewer than eight rows");
    if (answered_ == 0)
      add_answers(ccd_answers_of(csv_));
    else if (answered_ != rows_)
      fail("some rows above have an answer, and others have none");
    return std::move(queries_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw CcdProblem(csv_.string() + ", line " + std::to_string(line_) + ": " + problem);
  }

  void add_row(const std::vector<std::string>& fields) {
    const std::size_t columns = fields.size();
    if (columns != 3 && columns != 4 && columns != 6 && columns != 7)
      fail("has " + std::to_string(columns) + " columns instead of 6 or 7, or 3 or 4");
    const std::size_t row = rows_++ % kRows;
    if (row == 0) {
      queries_.emplace_back();
      queries_.back().origin = csv_.string() + ", query " + std::to_string(queries_.size());
      queries_.back().kind = kind_;
    }
    const std::size_t width = columns / 3;
    for (std::size_t axis = 0; axis < 3; ++axis)
      queries_.back().points[row][axis] =
          width == 1 ? number_in(fields[axis]) : fraction(fields[2 * axis], fields[2 * axis + 1]);
    if (columns > 3 * width) add_answer(fields.back(), row);
  }

  mpq_class number_in(const std::string& text) const {
    const auto value = number(text);
    if (!value) fail("expected a number, not '" + text + "'");
    return *value;
  }

  mpq_class fraction(const std::string& numerator, const std::string& denominator) const {
    const mpq_class below = number_in(denominator);
    if (below == 0) fail("the denominator is 0");
    return number_in(numerator) / below;
  }

  void add_answer(const std::string& text, std::size_t row) {
    const std::optional<bool> answer = ccd_answer(text);
    if (!answer) fail("expected the answer 0 or 1, not '" + text + "'");
    if (row != 0 && queries_.back().meets != *answer) fail("has another answer than the row above");
    queries_.back().meets = *answer;
    ++answered_;
  }

  void add_answers(const std::vector<bool>& answers) {
    if (answers.size() != queries_.size())
      throw CcdProblem(csv_.string() + " has " + std::to_string(queries_.size()) +
                       " queries, but its JSON file has " + std::to_string(answers.size()) +
                       " answers");
    for (std::size_t i = 0; i < answers.size(); ++i) queries_[i].meets = answers[i];
  }

  fs::path csv_;
  CcdKind kind_;
  std::vector<CcdQuery> queries_;
  std::size_t line_ = 0, rows_ = 0, answered_ = 0;
};

/// The words of a name, in lower case. Digits and signs separate words.
std::vector<std::string> words_of(const fs::path& name) {
  std::vector<std::string> words(1);
  for (const unsigned char c : name.string()) {
    if (std::isalpha(c) != 0)
      words.back() += static_cast<char>(std::tolower(c));
    else
      words.emplace_back();
  }
  std::erase(words, "");
  return words;
}

std::optional<CcdKind> kind_by_words(const fs::path& name) {
  const std::vector<std::string> words = words_of(name);
  const auto has = [&](const std::vector<std::string>& sequence) {
    return std::search(words.begin(), words.end(), sequence.begin(), sequence.end()) != words.end();
  };
  const bool is_edges = has({"edge", "edge"}) || has({"ee"});
  const bool is_face = has({"vertex", "face"}) || has({"vf"});
  if (is_edges == is_face) return std::nullopt;
  return is_edges ? CcdKind::edge_edge : CcdKind::vertex_face;
}

/// Nullopt if the file does not exist or holds anything else.
std::optional<std::vector<bool>> answers_in(const fs::path& json) {
  std::ifstream stream(json);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  text.back() = ',';
  std::vector<bool> answers;
  for (std::size_t start = 1; start < text.size();) {
    const std::size_t end = text.find(',', start);
    const std::optional<bool> answer = ccd_answer(text.substr(start, end - start));
    if (!answer) return std::nullopt;
    answers.push_back(*answer);
    start = end + 1;
  }
  return answers;
}

std::vector<fs::path> folders_with_answers(const fs::path& folder) {
  std::vector<fs::path> folders = {folder, folder / "mma_bool", folder.parent_path() / "mma_bool"};
  fs::path copy;
  for (const fs::path& part : folder) copy /= part == "queries" ? "mma_bool" : part;
  folders.push_back(copy);
  for (const auto& entry : fs::directory_iterator(folder / ".."))
    if (entry.is_directory()) folders.push_back(entry.path());
  std::sort(folders.begin() + 4, folders.end());
  return folders;
}

}  // namespace

std::vector<CcdQuery> read_ccd_queries(const fs::path& csv) { return Reader(csv).read(); }

CcdKind ccd_kind_of(const fs::path& csv) {
  if (const auto kind = kind_by_words(csv.stem())) return *kind;
  for (fs::path folder = csv.parent_path(); folder.has_filename(); folder = folder.parent_path())
    if (const auto kind = kind_by_words(folder.filename())) return *kind;
  if (csv.stem().string().ends_with("ee")) return CcdKind::edge_edge;
  if (csv.stem().string().ends_with("vf")) return CcdKind::vertex_face;
  throw CcdProblem(
      csv.string() +
      " is neither edge-edge nor vertex-face by the names of the file and its folders");
}

std::optional<bool> ccd_answer(const std::string& text) {
  if (text == "1" || text == "true") return true;
  if (text == "0" || text == "false") return false;
  return std::nullopt;
}

std::vector<bool> ccd_answers_of(const fs::path& csv) {
  const std::string name = csv.stem().string();
  for (const fs::path& folder : folders_with_answers(csv.parent_path()))
    for (const char* end : {".json", "_mma_bool.json"})
      if (const auto answers = answers_in(folder / (name + end))) return *answers;
  throw CcdProblem(csv.string() + " has no column with answers, and no file " + name + ".json or " +
                   name + "_mma_bool.json has them");
}

}  // namespace pelt::test
