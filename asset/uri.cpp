#include "asset/uri.hpp"

#include "asset/little_endian.hpp"
#include "asset/parsed_json.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string>

namespace pelt::asset {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> percent_decode(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    if (text.size() - i < 3) return std::nullopt;
    const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    decoded += static_cast<char>(16 * high + low);
    i += 2;
  }
  return decoded;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

std::optional<std::vector<std::byte>> base64_decode(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = base64_digit(text[i]);
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    // Characters 1, 2 and 3 of a group of four complete one byte each.
    const std::size_t spare = 6 - 2 * (i % 4);
    if (i % 4 != 0) bytes.push_back(static_cast<std::byte>(bits >> spare & 0xFF));
  }
  return bytes;
}

/// Whether the path never leaves the folder that it is appended to, on every platform.
bool stays_below(const std::string& path) {
  if (path.empty() || path.front() == '/') return false;
  if (path.find_first_of(std::string_view("\\:\0", 3)) != std::string::npos) return false;
  const fs::path parts(path);
  return std::find(parts.begin(), parts.end(), "..") == parts.end();
}

/// Whether `path` is inside `folder` after links in both have been resolved.
bool lies_in(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(path, error);
  if (error) return false;
  const fs::path outer = fs::canonical(folder, error);
  if (error) return false;
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

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

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

Result<std::vector<std::byte>> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) return text::malformed("a data URI without a comma");
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    std::optional<std::vector<std::byte>> bytes = base64_decode(data);
    if (!bytes) return text::malformed("a data URI that is not base64");
    return *std::move(bytes);
  }
  const std::optional<std::string> text = percent_decode(data);
  if (!text) return text::malformed("a data URI with an invalid percent code");
  const auto* first = reinterpret_cast<const std::byte*>(text->data());
  return std::vector<std::byte>(first, first + text->size());
}

std::optional<fs::path> relative_file(std::string_view uri) {
  if (is_data_uri(uri)) return std::nullopt;
  const std::optional<std::string> path = percent_decode(uri);
  if (!path) return std::nullopt;
  return fs::path(*path);
}

Result<fs::path> resolve_file_uri(std::string_view uri, const fs::path& folder) {
  const std::optional<std::string> path = percent_decode(uri);
  if (!path || !stays_below(*path)) {
    return text::malformed("uri " + text::quoted(uri) +
                           " is not the name of a file in the folder of the .gltf");
  }
  if (folder.empty()) {
    return text::unsupported(
        "uri " + text::quoted(uri) +
        " refers to a file, but there is no folder to look in: export a .glb, which "
        "is self-contained");
  }
  const fs::path file = folder / *path;
  if (!lies_in(file, folder)) {
    return text::malformed("uri " + text::quoted(uri) + " leaves the folder of the .gltf");
  }
  return file;
}

std::vector<fs::path> referenced_files(const fs::path& path) {
  std::vector<fs::path> files;
  const Result<ParsedJson> json = parse_json(read_json_text(path));
  if (!json || !(*json)->is_object()) return files;
  for (const char* array : {"buffers", "images"})
    add_files(**json, array, path.parent_path(), files);
  return files;
}

}  // namespace pelt::asset
