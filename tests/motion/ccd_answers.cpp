#include "ccd_answers.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

namespace pelt::test {
namespace {

namespace fs = std::filesystem;

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
