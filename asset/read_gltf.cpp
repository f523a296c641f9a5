#include "asset/read_gltf.hpp"

#include "asset/clip_reader.hpp"
#include "asset/container.hpp"
#include "asset/file_bytes.hpp"
#include "asset/mesh_merge.hpp"
#include "asset/transform.hpp"
#include "text/message.hpp"

#include <optional>

namespace pelt::asset {
namespace {

/// Returns for each vertex whether it belongs to a part whose `skinned` has this value.
std::vector<bool> vertices_of_parts(const Asset& asset, bool skinned) {
  std::vector<bool> belongs(asset.rest_positions.size(), false);
  for (const Part& part : asset.parts) {
    if (part.skinned != skinned) continue;
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      for (const std::uint32_t v : asset.triangles[part.first_triangle + t]) belongs[v] = true;
    }
  }
  return belongs;
}

/// Returns for each joint whether any of these vertices follows it.
std::vector<bool> joints_of(const Asset& asset, const std::vector<bool>& vertices) {
  std::vector<bool> named(asset.joints.size(), false);
  for (std::size_t i = 0; i < asset.joint_indices.size(); ++i) {
    const bool counts = vertices[i / asset.influences_per_vertex] && asset.weights[i] > 0;
    if (counts) named[asset.joint_indices[i]] = true;
  }
  return named;
}

Vec3 transformed(const Affine& m, const Vec3& p) {
  const double x = p.x, y = p.y, z = p.z;
  const auto row = [&](std::size_t r) {
    return static_cast<float>((m[r] * x + m[3 + r] * y) + (m[6 + r] * z + m[9 + r]));
  };
  return {row(0), row(1), row(2)};
}

/// Transforms a displacement by the linear part alone.
Vec3 turned(Affine m, const Vec3& displacement) {
  m[9] = m[10] = m[11] = 0;
  return transformed(m, displacement);
}

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
    asset.warnings.push_back("extension " + text::quoted(extension) + " is ignored");
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

/// Adds the remedy for a file that violates the glTF format, which Pelt cannot repair. Returns
/// errors of other kinds unchanged.
Error with_remedy(const Error& error) {
  if (error.code != ErrorCode::malformed_file) return error;
  return text::malformed(error.message +
                         ": fix it in the program that wrote the file, and export it again");
}

}  // namespace

void assemble(Asset& asset) {
  SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  sample_palette(asset, nullptr, 0, Matrix4{}, scratch, palette);

  const std::vector<bool> riding = vertices_of_parts(asset, false);
  const std::vector<bool> used_by_riding = joints_of(asset, riding);
  const std::vector<bool> used_by_skins = joints_of(asset, vertices_of_parts(asset, true));
  std::vector<std::optional<Affine>> placement(asset.joints.size());
  for (std::size_t j = 0; j < asset.joints.size(); ++j) {
    if (!used_by_riding[j] || used_by_skins[j]) continue;
    const Affine global = scratch.globals[asset.joints[j].node];
    const std::optional<Affine> inverse = inverted(global);
    if (!inverse || global == affine_of(Matrix4{})) continue;
    placement[j] = global;
    asset.joints[j].inverse_bind = matrix_of(*inverse);
  }
  const auto placement_of = [&](std::size_t v) {
    const auto& moved = placement[asset.joint_indices[v * asset.influences_per_vertex]];
    return riding[v] && moved ? &*moved : nullptr;
  };
  for (std::size_t v = 0; v < asset.rest_positions.size(); ++v) {
    if (const Affine* moved = placement_of(v))
      asset.rest_positions[v] = transformed(*moved, asset.rest_positions[v]);
  }
  for (std::size_t i = 0; i < asset.morph_vertices.size(); ++i) {
    if (const Affine* moved = placement_of(asset.morph_vertices[i]))
      asset.morph_displacements[i] = turned(*moved, asset.morph_displacements[i]);
  }
}

Result<Asset> load_gltf(const std::filesystem::path& path, const GltfOptions& options) {
  return within_memory(path, [&]() -> Result<Asset> {
    const Result<std::vector<std::byte>> file = read_file(path, check_beginning);
    if (!file) return file.error();
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    Result<Asset> asset = load_gltf(*file, folder, options);
    if (!asset) return text::prefixed(path.string(), asset.error());
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
