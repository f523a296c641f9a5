#include "tools/pelt/page/geometry_copy.hpp"

#include "asset/buffers.hpp"
#include "asset/container.hpp"
#include "asset/parsed_json.hpp"
#include "scenes/glb_builder.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace pelt::tools::page {
namespace {

using Json = nlohmann::json;

using Bytes = std::span<const std::byte>;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// Moves these members of an object to a new object.
Json take_members(Json& object, std::initializer_list<const char*> keys) {
  Json taken = Json::object();
  for (const char* key : keys)
    if (const auto found = object.find(key); found != object.end()) taken[key] = std::move(*found);
  return taken;
}

/// Returns the elements of an array of the document, which may be absent.
Json::array_t& elements(Json& document, const char* key) {
  return document.emplace(key, Json::array()).first->get_ref<Json::array_t&>();
}

void remove_custom_data(Json& value) {
  if (value.is_object()) {
    value.erase("extras");
    value.erase("extensions");
  }
  for (Json& child : value)
    if (child.is_structured()) remove_custom_data(child);
}

void keep_attributes(Json& object) {
  for (auto it = object.begin(); it != object.end();) {
    const std::string& name = it.key();
    const bool is_read =
        name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
    it = is_read ? std::next(it) : object.erase(it);
  }
}

void reduce_primitive(Json& primitive) {
  primitive = take_members(primitive, {"attributes", "indices", "material", "mode", "targets"});
  if (primitive.contains("attributes")) keep_attributes(primitive["attributes"]);
  for (Json& target : elements(primitive, "targets")) keep_attributes(target);
  if (primitive["targets"].empty()) primitive.erase("targets");
}

/// Keeps the names of morph targets, which exporters write to the extras.
void reduce_mesh(Json& mesh) {
  Json names = Json::object();
  if (mesh.contains("extras") && mesh["extras"].is_object())
    names = take_members(mesh["extras"], {"targetNames"});
  mesh = take_members(mesh, {"name", "weights", "primitives"});
  for (Json& primitive : elements(mesh, "primitives")) reduce_primitive(primitive);
  remove_custom_data(mesh);
  if (!names.empty()) mesh["extras"] = std::move(names);
}

/// Makes accessors of other views zeros, so that they need no bytes.
void reduce_accessor(Json& accessor, std::span<const std::uint32_t> views) {
  const auto is_used = [&](const Json& view) {
    return std::binary_search(views.begin(), views.end(), view.get<std::uint32_t>());
  };
  remove_custom_data(accessor);
  if (accessor.contains("bufferView") && !is_used(accessor["bufferView"])) {
    accessor.erase("bufferView");
    accessor.erase("byteOffset");
  }
  if (accessor.contains("sparse") && !is_used(accessor["sparse"]["indices"]["bufferView"]))
    accessor.erase("sparse");
}

/// The single buffer of the copy. A second buffer without bytes stands for decompressed views.
class PackedBuffer {
 public:
  /// Appends the stored bytes of a view, and lets the view refer to them. Borrows the bytes.
  void add(Json& view, Bytes stored) {
    const std::size_t offset = place_of(stored);
    Json meshopt;
    if (view.contains("extensions") && view["extensions"].contains(kMeshopt))
      meshopt = std::move(view["extensions"][kMeshopt]);
    remove_custom_data(view);
    Json& place = meshopt.is_null() ? view : meshopt;
    place["buffer"] = 0;
    place["byteOffset"] = offset;
    if (meshopt.is_null()) return;
    view["buffer"] = 1;
    view["byteOffset"] = 0;
    decompressed_ = std::max(decompressed_, view["byteLength"].get<std::uint64_t>());
    view["extensions"][kMeshopt] = std::move(meshopt);
  }

  Json buffers() const {
    Json all = Json::array({{{"byteLength", bytes_.size()}}});
    if (decompressed_ > 0)
      all.push_back(
          {{"byteLength", decompressed_}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}});
    return all;
  }

  Bytes bytes() const { return bytes_; }

 private:
  /// Several views may have the same bytes.
  std::size_t place_of(Bytes stored) {
    const auto [known, is_new] = places_.try_emplace({stored.data(), stored.size()}, bytes_.size());
    if (!is_new) return known->second;
    bytes_.insert(bytes_.end(), stored.begin(), stored.end());
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    return known->second;
  }

  std::map<std::pair<const std::byte*, std::size_t>, std::size_t> places_;
  std::vector<std::byte> bytes_;
  std::uint64_t decompressed_ = 0;  // length of the longest view
};

void reduce_structure(Json& document, std::span<const std::uint32_t> views) {
  document = take_members(
      document, {"asset", "extensionsUsed", "extensionsRequired", "scene", "scenes", "nodes",
                 "meshes", "skins", "animations", "materials", "accessors", "bufferViews"});
  for (Json& material : elements(document, "materials"))
    material = take_members(material, {"name"});
  for (Json& mesh : elements(document, "meshes")) reduce_mesh(mesh);
  for (Json& node : elements(document, "nodes")) node.erase("camera");
  for (const char* key : {"asset", "scenes", "nodes", "skins", "animations"})
    if (document.contains(key)) remove_custom_data(document[key]);
  for (Json& accessor : elements(document, "accessors")) reduce_accessor(accessor, views);
}

/// Packs the used views. The other ones keep their place, because accessors count views.
Result<PackedBuffer> pack_views(Json::array_t& all, std::span<const std::uint32_t> used,
                                asset::Buffers& buffers) {
  std::vector<Json> unused(all.size(), {{"buffer", 0}, {"byteLength", 1}});
  PackedBuffer packed;
  for (const std::uint32_t view : used) {
    const auto stored = buffers.stored_view(view, text::label("bufferView", view));
    if (!stored) return stored.error();
    packed.add(all[view], *stored);
    unused[view] = std::move(all[view]);
  }
  all = std::move(unused);
  return packed;
}

/// glTF has no empty arrays.
void remove_empty_arrays(Json& document) {
  for (auto it = document.begin(); it != document.end();)
    it = it->is_array() && it->empty() ? document.erase(it) : std::next(it);
}

}  // namespace

Result<std::vector<std::byte>> copy_geometry(Bytes file, const std::filesystem::path& folder,
                                             std::span<const std::uint32_t> views) {
  const auto container = asset::open_container(file);
  if (!container) return container.error();
  const auto gltf = asset::read_document(container->json);
  if (!gltf) return gltf.error();
  const auto parsed = asset::parse_json(container->json);
  if (!parsed) return parsed.error();
  asset::Budget budget;
  asset::Buffers buffers(*gltf, container->binary, folder, budget);
  Json& document = **parsed;
  reduce_structure(document, views);
  const auto packed = pack_views(elements(document, "bufferViews"), views, buffers);
  if (!packed) return packed.error();
  document["buffers"] = packed->buffers();
  remove_empty_arrays(document);
  const std::string text = document.dump();
  if (text.size() + packed->bytes().size() > std::numeric_limits<std::uint32_t>::max() - 64)
    return text::unsupported("is too large for a page: 4 GB is the limit of a .glb");
  return scenes::make_glb_file(text, packed->bytes());
}

}  // namespace pelt::tools::page
