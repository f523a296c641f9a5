#include "asset/assemble.hpp"
#include "asset/clip_reader.hpp"
#include "asset/container.hpp"
#include "asset/file_bytes.hpp"
#include "asset/mesh_merge.hpp"
#include "asset/message.hpp"
#include "asset/read_gltf.hpp"

namespace pelt::asset {

namespace {

std::vector<Node> take_nodes(const NodeGraph& graph, GltfDocument& document) {
  std::vector<Node> nodes;
  nodes.reserve(graph.order.size());
  for (std::size_t i = 0; i < graph.order.size(); ++i) {
    GltfNode& source = document.nodes[graph.order[i]];
    nodes.push_back(
        {std::move(source.name), graph.parent[i], source.local, source.has_matrix, source.matrix});
  }
  return nodes;
}

Result<Asset> read_asset(GltfDocument& document, Buffers& buffers, Budget& budget,
                         const GltfOptions& options) {
  const Result<NodeGraph> graph = order_nodes(document);
  if (!graph) return graph.error();
  Asset asset;
  for (const std::string& extension : document.passed_over_extensions) {
    asset.warnings.push_back("extension " + asset::quoted(extension) + " is ignored");
  }
  AccessorReader reader(document, buffers, budget);
  const Result<void> merged = merge_meshes(document, *graph, options, reader, budget, asset);
  if (!merged) return merged.error();
  Result<std::vector<Clip>> clips =
      read_clips(document, *graph, reader, asset.morph_targets, asset.warnings);
  if (!clips) return clips.error();
  asset.clips = *std::move(clips);
  asset.nodes = take_nodes(*graph, document);
  assemble(asset);
  return asset;
}

}  // namespace

Result<Asset> load_gltf(const std::filesystem::path& path, const GltfOptions& options) {
  return within_memory(path, [&]() -> Result<Asset> {
    const Result<std::vector<std::byte>> file = read_file(path, check_beginning);
    if (!file) return file.error();
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    Result<Asset> asset = load_gltf(*file, folder, options);
    if (!asset) return prefixed(path.string(), asset.error());
    return asset;
  });
}

Result<Asset> load_gltf(std::span<const std::byte> file, const std::filesystem::path& folder,
                        const GltfOptions& options) {
  Result<ReadGltf> read = read_gltf(file, folder, options);
  if (!read) return read.error();
  return std::move(read->asset);
}

Result<ReadGltf> read_gltf(std::span<const std::byte> file, const std::filesystem::path& folder,
                           const GltfOptions& options) {
  const Result<Container> container = open_container(file);
  if (!container) return container.error();
  Result<GltfDocument> document = read_document(container->json);
  if (!document) return with_remedy(document.error());
  Budget budget;
  budget.grant(file.size());
  Buffers buffers(*document, container->binary, folder, budget);
  Result<Asset> asset = read_asset(*document, buffers, budget, options);
  if (!asset) return with_remedy(asset.error());
  const std::set<std::uint32_t>& views = buffers.views_read();
  return ReadGltf{*std::move(asset), {views.begin(), views.end()}};
}

}  // namespace pelt::asset
