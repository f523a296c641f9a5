#include "tools/pelt/page/character_files.hpp"

#include "asset/container.hpp"
#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/uri.hpp"
#include "base/hash.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;

/// The URIs of files that buffers lie in. The file has been read before: it is sound.
std::vector<std::string> buffer_uris(std::span<const std::byte> file) {
  std::vector<std::string> uris;
  const auto container = asset::open_container(file);
  if (!container) return uris;
  const auto parsed = asset::parse_json(container->json);
  if (!parsed || !parsed->contains("buffers")) return uris;
  for (const nlohmann::json& buffer : (*parsed)["buffers"]) {
    const std::string uri = buffer.value("uri", "");
    if (!uri.empty() && !asset::is_data_uri(uri)) uris.push_back(uri);
  }
  return uris;
}

/// Another process may have written it meanwhile.
Result<void> check_unchanged(const scenes::Character& character, std::span<const std::byte> bytes) {
  detail::Fnv1a64 hash;
  hash.add_bytes(bytes);
  if (hash.value() == character.hash) return {};
  return Error{ErrorCode::unreadable_file,
               character.source + ": was changed after it was read: try again"};
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
    const scenes::Character& character = scene.characters[c];
    const auto* path = std::get_if<fs::path>(&character.origin);
    files.paths.emplace_back();
    if (!path) continue;
    const std::string folder = std::to_string(c) + "/";
    files.paths.back() = folder + path->filename().string();
    if (const auto added = add_file(*path, files.paths.back(), files); !added) return added.error();
    const auto unchanged = check_unchanged(character, files.bytes[files.paths.back()]);
    if (!unchanged) return unchanged.error();
    if (const auto added = add_buffers(*path, folder, files); !added) return added.error();
  }
  return files;
}

}  // namespace pelt::tools::page
