#include "scenes/creature/surface_mesh.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <utility>

namespace pelt::scenes {
namespace {

/// A half-edge with the key of its undirected edge.
struct NamedHalfEdge {
  std::uint64_t edge = 0;
  std::uint32_t half_edge = 0;
};

std::vector<NamedHalfEdge> sorted_by_edge(std::span<const Triangle> triangles) {
  std::vector<NamedHalfEdge> result;
  result.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
      result.push_back({edge, static_cast<std::uint32_t>(result.size())});
    }
  }
  std::sort(result.begin(), result.end(), [](const NamedHalfEdge& a, const NamedHalfEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.half_edge < b.half_edge;
  });
  return result;
}

}  // namespace

SurfaceMesh::SurfaceMesh(std::span<const Triangle> triangles, std::uint32_t vertex_count)
    : twin_(3 * triangles.size()),
      outgoing_(vertex_count, kDead),
      live_triangles_(static_cast<std::uint32_t>(triangles.size())) {
  origin_.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (std::uint32_t v : triangle) {
      outgoing_[v] = static_cast<std::uint32_t>(origin_.size());
      origin_.push_back(v);
    }
  }
  const std::vector<NamedHalfEdge> half_edges = sorted_by_edge(triangles);
  for (std::size_t i = 0; i + 1 < half_edges.size(); i += 2) {
    PELT_ASSERT(half_edges[i].edge == half_edges[i + 1].edge);
    make_twins(half_edges[i].half_edge, half_edges[i + 1].half_edge);
  }
}

void SurfaceMesh::make_twins(std::uint32_t h, std::uint32_t g) {
  twin_[h] = g;
  twin_[g] = h;
}

std::uint32_t SurfaceMesh::valence(std::uint32_t vertex) const {
  std::uint32_t count = 0;
  for_each_outgoing(vertex, [&](std::uint32_t) { ++count; });
  return count;
}

bool SurfaceMesh::are_neighbours(std::uint32_t a, std::uint32_t b) const {
  bool found = false;
  for_each_outgoing(a, [&](std::uint32_t h) { found = found || target(h) == b; });
  return found;
}

bool SurfaceMesh::can_collapse(std::uint32_t h) const {
  const std::uint32_t a = origin(h), b = target(h);
  if (valence(origin(previous(h))) < 4 || valence(origin(previous(twin(h)))) < 4) return false;
  int common = 0;
  for_each_outgoing(a, [&](std::uint32_t from_a) {
    for_each_outgoing(b, [&](std::uint32_t from_b) { common += target(from_a) == target(from_b); });
  });
  return common == 2;
}

void SurfaceMesh::kill_triangle(std::uint32_t h) {
  origin_[h] = origin_[next(h)] = origin_[previous(h)] = kDead;
  --live_triangles_;
}

void SurfaceMesh::collapse(std::uint32_t h) {
  const std::uint32_t a = origin(h), b = target(h), g = twin(h);
  const std::uint32_t left = origin(previous(h)), right = origin(previous(g));
  for_each_outgoing(b, [&](std::uint32_t from_b) { origin_[from_b] = a; });
  const std::uint32_t a_to_left = twin(previous(h)), left_to_a = twin(next(h));
  const std::uint32_t right_to_a = twin(next(g)), a_to_right = twin(previous(g));
  make_twins(a_to_left, left_to_a);
  make_twins(a_to_right, right_to_a);
  kill_triangle(h);
  kill_triangle(g);
  outgoing_[a] = a_to_left;
  outgoing_[left] = left_to_a;
  outgoing_[right] = right_to_a;
  outgoing_[b] = kDead;
}

bool SurfaceMesh::can_flip(std::uint32_t h) const {
  const std::uint32_t left = origin(previous(h)), right = origin(previous(twin(h)));
  return valence(origin(h)) > 3 && valence(target(h)) > 3 && !are_neighbours(left, right);
}

void SurfaceMesh::flip(std::uint32_t h) {
  const std::uint32_t g = twin(h);
  const std::uint32_t a = origin(h), b = target(h);
  const std::uint32_t left = origin(previous(h)), right = origin(previous(g));
  const std::uint32_t b_left = twin(next(h)), left_a = twin(previous(h));
  const std::uint32_t a_right = twin(next(g)), right_b = twin(previous(g));
  // h runs from right to left in (right, left, a), g from left to right in (left, right, b).
  origin_[h] = right;
  origin_[next(h)] = left;
  origin_[previous(h)] = a;
  origin_[g] = left;
  origin_[next(g)] = right;
  origin_[previous(g)] = b;
  make_twins(next(h), left_a);
  make_twins(previous(h), a_right);
  make_twins(next(g), right_b);
  make_twins(previous(g), b_left);
  outgoing_[a] = previous(h);
  outgoing_[b] = previous(g);
  outgoing_[left] = next(h);
  outgoing_[right] = next(g);
}

std::vector<Triangle> SurfaceMesh::live_triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(live_triangles_);
  for (std::uint32_t h = 0; h < half_edge_count(); h += 3) {
    if (is_live_half_edge(h)) triangles.push_back({origin_[h], origin_[h + 1], origin_[h + 2]});
  }
  return triangles;
}

}  // namespace pelt::scenes
