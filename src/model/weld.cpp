#include "model/weld.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <cstring>
#include <span>

namespace pelt::detail {
namespace {

struct Key {
  std::uint64_t hash;
  std::uint32_t vertex;
};

Key key_of(const SkinnedMesh& mesh, std::uint32_t vertex) {
  Fnv1a64 hash;
  hash.add_bytes(std::as_bytes(std::span(&mesh.rest_positions[vertex], 1)));
  hash.add_bytes(std::as_bytes(mesh.influences_of(vertex)));
  return {hash.value(), vertex};
}

/// Less than, equal to or greater than zero; any order will do that knows equal bits.
int compare_vertices(const SkinnedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto of_a = mesh.influences_of(a), of_b = mesh.influences_of(b);
  if (of_a.size() != of_b.size()) return of_a.size() < of_b.size() ? -1 : 1;
  const int order = std::memcmp(&mesh.rest_positions[a], &mesh.rest_positions[b], sizeof(Vec3));
  return order != 0 ? order : std::memcmp(of_a.data(), of_b.data(), of_a.size_bytes());
}

}  // namespace

// Sorted, not looked up in a hash table: a file can be made whose vertices all have one hash.
std::vector<std::uint32_t> weld_vertices(const SkinnedMesh& mesh) {
  std::vector<Key> keys;
  keys.reserve(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) keys.push_back(key_of(mesh, v));
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.hash != b.hash) return a.hash < b.hash;
    const int order = compare_vertices(mesh, a.vertex, b.vertex);
    return order != 0 ? order < 0 : a.vertex < b.vertex;
  });

  std::vector<std::uint32_t> welded(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::uint32_t v = keys[i].vertex;
    const bool same = i > 0 && keys[i - 1].hash == keys[i].hash &&
                      compare_vertices(mesh, keys[i - 1].vertex, v) == 0;
    welded[v] = same ? welded[keys[i - 1].vertex] : v;
  }
  return welded;
}

}  // namespace pelt::detail
