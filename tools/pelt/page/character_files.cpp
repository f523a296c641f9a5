#include "tools/pelt/page/character_files.hpp"

#include "asset/file_bytes.hpp"
#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "base/hash.hpp"
#include "tools/pelt/page/geometry_copy.hpp"

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;

/// The page is text, and so are the paths in it.
std::string name_in_page(const fs::path& path) {
  const std::string name = path.stem().string();
  return (asset::as_utf8(name) == name ? name : "model") + ".glb";
}

/// Another process may have changed the file since it was read.
Result<void> check_unchanged(const scenes::Character& character, std::span<const std::byte> bytes) {
  detail::Fnv1a64 hash;
  hash.add_bytes(bytes);
  if (hash.value() == character.hash) return {};
  return Error{ErrorCode::unreadable_file,
               character.source + ": was changed after it was read: try again"};
}

Result<void> add_character(const scenes::Character& character, const fs::path& path,
                           const std::string& folder, CharacterFiles& files) {
  const auto original = asset::read_file(path);
  if (!original) return original.error();
  if (const auto unchanged = check_unchanged(character, *original); !unchanged) return unchanged;
  const fs::path beside = path.has_parent_path() ? path.parent_path() : ".";
  auto copy = copy_geometry(*original, beside, character.buffer_views);
  if (!copy) return asset::prefixed(character.source, copy.error());
  files.paths.back() = folder + name_in_page(path);
  files.original_sizes.back() = original->size();
  files.bytes[files.paths.back()] = *std::move(copy);
  return {};
}

}  // namespace

Result<CharacterFiles> read_character_files(const scenes::Scene& scene) {
  CharacterFiles files;
  for (std::size_t c = 0; c < scene.characters.size(); ++c) {
    const scenes::Character& character = scene.characters[c];
    files.paths.emplace_back();
    files.original_sizes.emplace_back();
    const auto* path = std::get_if<fs::path>(&character.origin);
    if (!path) continue;
    const auto added = add_character(character, *path, std::to_string(c) + "/", files);
    if (!added) return added.error();
  }
  return files;
}

}  // namespace pelt::tools::page
