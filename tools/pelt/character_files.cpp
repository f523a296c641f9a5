#include "tools/pelt/character_files.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/uri.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools {
namespace {

namespace fs = std::filesystem;

/// The URIs of files that a .gltf's buffers lie in. The file has been read before: it is sound.
std::vector<std::string> buffer_uris(std::span<const std::byte> gltf) {
  std::vector<std::string> uris;
  const auto parsed = asset::parse_json({reinterpret_cast<const char*>(gltf.data()), gltf.size()});
  if (!parsed || !parsed->contains("buffers")) return uris;
  for (const nlohmann::json& buffer : (*parsed)["buffers"]) {
    const std::string uri = buffer.value("uri", "");
    if (!uri.empty() && !asset::is_data_uri(uri)) uris.push_back(uri);
  }
  return uris;
}

Result<void> add_file(const fs::path& path, const std::string& name, CharacterFiles& files) {
  auto bytes = asset::read_file(path);
  if (!bytes) return bytes.error();
  files.bytes[name] = std::move(*bytes);
  return {};
}

Result<void> add_buffers(const fs::path& path, const std::string& folder, CharacterFiles& files) {
  const fs::path beside = path.has_parent_path() ? path.parent_path() : ".";
  for (const std::string& uri : buffer_uris(files.bytes[folder + path.filename().string()])) {
    const auto file = asset::resolve_file_uri(uri, beside);
    if (!file) return file.error();
    const std::string name = fs::relative(*file, beside).generic_string();
    if (const auto added = add_file(*file, folder + name, files); !added) return added.error();
  }
  return {};
}

}  // namespace

Result<CharacterFiles> read_character_files(const scenes::Scene& scene) {
  CharacterFiles files;
  for (std::size_t c = 0; c < scene.characters.size(); ++c) {
    const auto* path = std::get_if<fs::path>(&scene.characters[c].origin);
    files.paths.emplace_back();
    if (!path) continue;
    const std::string folder = std::to_string(c) + "/";
    files.paths.back() = folder + path->filename().string();
    if (const auto added = add_file(*path, files.paths.back(), files); !added) return added.error();
    if (path->extension() != ".gltf") continue;
    if (const auto added = add_buffers(*path, folder, files); !added) return added.error();
  }
  return files;
}

}  // namespace pelt::tools
