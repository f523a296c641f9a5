#include "tools/pelt/page/character_files.hpp"

#include "asset/file_bytes.hpp"
#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "base/hash.hpp"

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;

bool is_utf8(const std::string& text) { return asset::as_utf8(text) == text; }

/// The page is text, and so are the paths in it.
std::string name_in_page(const fs::path& path) {
  const std::string name = path.filename().string();
  return is_utf8(name) ? name : "model" + path.extension().string();
}

/// Another process may have changed the file since it was read.
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

/// Adds the buffers under the names that the model uses, which the page's reader looks up.
Result<void> add_buffers(const scenes::Character& character, const fs::path& beside,
                         const std::string& folder, CharacterFiles& files) {
  for (const fs::path& file : character.buffer_files) {
    const std::string name = file.lexically_relative(beside).generic_string();
    if (!is_utf8(name))
      return Error{ErrorCode::unsupported,
                   character.source + ": its buffer " + asset::quoted(name) +
                       " has a name that is not UTF-8, which a page cannot have: rename it"};
    if (const auto added = add_file(file, folder + name, files); !added) return added.error();
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
    files.paths.back() = folder + name_in_page(*path);
    if (const auto added = add_file(*path, files.paths.back(), files); !added) return added.error();
    const auto unchanged = check_unchanged(character, files.bytes[files.paths.back()]);
    if (!unchanged) return unchanged.error();
    const fs::path beside = path->has_parent_path() ? path->parent_path() : ".";
    const auto added = add_buffers(character, beside, folder, files);
    if (!added) return added.error();
  }
  return files;
}

}  // namespace pelt::tools::page
