#include "model/weld.hpp"
#include "base/bits.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace pelt::detail {
namespace {

struct Key {
  std::array<std::uint32_t, 3> position;  // its bits
  std::uint32_t vertex;
};

/// Whether 0.0 and -0.0 are the same coordinate.
enum class Zeros { differ, agree };

Key key_of(const SkinnedMesh& mesh, std::uint32_t vertex, Zeros zeros) {
  const Vec3& p = mesh.rest_positions[vertex];
  const auto bits = [&](float coordinate) {
    return bits_as<std::uint32_t>(zeros == Zeros::agree ? coordinate + 0.0F : coordinate);
  };
  return {{bits(p.x), bits(p.y), bits(p.z)}, vertex};
}

/// Three-way comparison. Any total order suffices in which equal means equal bits.
template <typename T>
int compare(std::span<const T> a, std::span<const T> b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  return a.empty() ? 0 : std::memcmp(a.data(), b.data(), a.size_bytes());
}

int compare_displacements(const SkinnedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return compare(mesh.displacements_of(a), mesh.displacements_of(b));
}

int compare_caps(const SkinnedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  if (mesh.offset_caps.empty() || mesh.offset_caps[a] == mesh.offset_caps[b]) return 0;
  return mesh.offset_caps[a] < mesh.offset_caps[b] ? -1 : 1;
}

int compare_motion(const SkinnedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  if (const int caps = compare_caps(mesh, a, b); caps != 0) return caps;
  const int influences = compare(mesh.influences_of(a), mesh.influences_of(b));
  return influences != 0 ? influences : compare_displacements(mesh, a, b);
}

/// Returns for each vertex the lowest number of a vertex with the same rest position for which
/// `compare_rest` returns 0. Sorts instead of hashing, because a hostile file could give all
/// vertices the same hash.
template <typename Compare>
std::vector<std::uint32_t> weld(const SkinnedMesh& mesh, Zeros zeros, const Compare& compare_rest) {
  std::vector<Key> keys;
  keys.reserve(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) keys.push_back(key_of(mesh, v, zeros));
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.position != b.position) return a.position < b.position;
    const int order = compare_rest(mesh, a.vertex, b.vertex);
    return order != 0 ? order < 0 : a.vertex < b.vertex;
  });

  std::vector<std::uint32_t> welded(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::uint32_t v = keys[i].vertex;
    const bool same = i > 0 && keys[i - 1].position == keys[i].position &&
                      compare_rest(mesh, keys[i - 1].vertex, v) == 0;
    welded[v] = same ? welded[keys[i - 1].vertex] : v;
  }
  return welded;
}

}  // namespace

std::vector<std::uint32_t> weld_vertices(const SkinnedMesh& mesh) {
  return weld(mesh, Zeros::differ, compare_motion);
}

std::vector<std::uint32_t> weld_surface(const SkinnedMesh& mesh) {
  return weld(mesh, Zeros::agree, compare_displacements);
}

void index_welded_vertices(Tree& tree) {
  tree.welded_vertices.clear();
  for (std::uint32_t v = 0; v < tree.vertex_count(); ++v) {
    const std::uint32_t into = tree.place_vertices[tree.vertex_places[v]];
    if (into != v) tree.welded_vertices.push_back({v, into});
  }
  tree.welded_vertices.shrink_to_fit();
}

}  // namespace pelt::detail
