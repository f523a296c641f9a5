#include "tools/pelt/list/scene_list.hpp"

#include "asset/file_bytes.hpp"
#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

#include <string_view>
#include <unordered_map>

namespace pelt::tools::list {
namespace {

/// Removes the carriage return of a line that was written on Windows.
std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Error at_line(const std::string& path, std::size_t line, const std::string& problem,
              const std::string& remedy) {
  return output::bad_argument("--scenes: " + path + ": line " + std::to_string(line), problem,
                              remedy);
}

}  // namespace

Result<std::vector<std::string>> read_scene_list(const std::string& path) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return asset::prefixed("--scenes", bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  std::vector<std::string> scenes;
  std::unordered_map<std::string_view, std::size_t> lines;
  std::size_t number = 0;
  for (std::string_view line : output::split(text, '\n')) {
    ++number;
    line = without_return(line);
    if (line.empty()) continue;
    if (line.find('\0') != line.npos)
      return at_line(path, number, "is not text", "give a text file with a scene on each line");
    const auto [known, is_new] = lines.emplace(line, number);
    if (!is_new)
      return at_line(path, number,
                     asset::quoted(line) + " is already in line " + std::to_string(known->second),
                     "remove one of the two");
    scenes.emplace_back(line);
    if (scenes.size() > kMostScenes)
      return at_line(path, number, "is beyond the 10 million scenes of a list", "divide the list");
  }
  if (!scenes.empty()) return scenes;
  return output::bad_argument("--scenes: " + path, "lists no scene", "name one on each line");
}

}  // namespace pelt::tools::list
