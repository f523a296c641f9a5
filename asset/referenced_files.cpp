#include "asset/referenced_files.hpp"

#include "asset/little_endian.hpp"
#include "asset/parsed_json.hpp"
#include "asset/uri.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <string>

namespace pelt::asset {

namespace {

namespace fs = std::filesystem;

std::string read_up_to(std::istream& stream, std::uintmax_t count) {
  std::string text(count, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(count));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// The JSON text of a .gltf file, or of the first chunk of a .glb file.
std::string read_json_text(const fs::path& path) {
  constexpr std::size_t kHeaders = 20;  // of the .glb and of its first chunk
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return "";  // a pipe, for example: opening it again would wait for another writer
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "";
  const std::string begin = read_up_to(stream, std::min<std::uintmax_t>(size, kHeaders));
  if (begin.size() < kHeaders || begin.compare(0, 4, "glTF") != 0)
    return begin + read_up_to(stream, size - begin.size());
  const auto* length = reinterpret_cast<const std::byte*>(begin.data()) + 12;
  return read_up_to(stream, std::min<std::uintmax_t>(load<std::uint32_t>(length), size - kHeaders));
}

void add_files(const nlohmann::json& document, const char* array, const fs::path& folder,
               std::vector<fs::path>& files) {
  const auto found = document.find(array);
  if (found == document.end() || !found->is_array()) return;
  for (const nlohmann::json& element : *found) {
    if (!element.is_object() || !element.contains("uri") || !element["uri"].is_string()) continue;
    const auto file = relative_file(element["uri"].get_ref<const std::string&>());
    if (file) files.push_back(folder / *file);
  }
}

}  // namespace

std::vector<fs::path> referenced_files(const fs::path& path) {
  std::vector<fs::path> files;
  const Result<ParsedJson> json = parse_json(read_json_text(path));
  if (!json || !(*json)->is_object()) return files;
  for (const char* array : {"buffers", "images"})
    add_files(**json, array, path.parent_path(), files);
  return files;
}

}  // namespace pelt::asset
