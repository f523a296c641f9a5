#include <pelt/model.hpp>

#include "asset/container.hpp"
#include "asset/file_bytes.hpp"
#include "asset/message.hpp"
#include "asset/read_gltf.hpp"
#include "base/hash.hpp"
#include "scenes/scene.hpp"

namespace pelt::scenes {
namespace {

constexpr const char* kPrepared =
    "is a prepared model, which has no skeleton and no clips: give the glTF file that it was "
    "prepared from";

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  detail::Fnv1a64 hash;
  hash.add_bytes(bytes);
  return hash.value();
}

template <typename Options>
Character generated(const char* name, const std::string& source, asset::Asset&& asset,
                    const Options& options) {
  return {name, source, hash_of(std::as_bytes(std::span(source))), std::move(asset), options};
}

Result<void> check_beginning(std::span<const std::byte> beginning) {
  if (is_prepared_model(beginning)) return asset::unsupported(kPrepared);
  return asset::check_beginning(beginning);
}

Result<Character> read_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options) {
  const Result<std::vector<std::byte>> file = asset::read_file(path, check_beginning);
  if (!file) return file.error();
  // A path without a folder is relative to the working directory; an empty folder would mean that
  // there are no external files.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  Result<asset::ReadGltf> read = asset::read_gltf(*file, folder, options);
  if (!read) return asset::prefixed(path.string(), read.error());
  return Character{path.stem().string(),   path.string(), hash_of(*file),
                   std::move(read->asset), path,          std::move(read->views)};
}

}  // namespace

Result<Character> load_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options) {
  return asset::within_memory(path, [&] { return read_character(path, options); });
}

Result<Character> generate_character(const CreatureOptions& options) {
  Result<asset::Asset> creature = make_creature(options);
  if (!creature) return creature.error();
  const std::string source = "creature:" + std::to_string(options.triangles) + ":" +
                             std::to_string(options.joints) + ":" + std::to_string(options.seed);
  return generated("creature", source, std::move(*creature), options);
}

Result<Character> generate_character(const FaceOptions& options) {
  Result<asset::Asset> face = make_face(options);
  if (!face) return face.error();
  const std::string source =
      "face:" + std::to_string(options.triangles) + ":" + std::to_string(options.seed);
  return generated("face", source, std::move(*face), options);
}

}  // namespace pelt::scenes
