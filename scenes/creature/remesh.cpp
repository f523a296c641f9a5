#include "scenes/creature/remesh.hpp"

#include "base/assert.hpp"
#include "scenes/creature/surface_mesh.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

namespace pelt::scenes {
namespace {

constexpr double kWorstShape = 0.15;  // of triangles after collapses and flips
constexpr double kLeastFacing = 0.3;  // cosine between a triangle and the surface under it
constexpr double kLeastStrictness = 0.01;
constexpr std::uint32_t kMaxValence = 9;  // of vertices after collapses
constexpr int kRelaxations = 3;

/// An edge in the queue. Stale if one of its ends has changed since.
struct Candidate {
  double relative_length = 0;
  std::uint32_t half_edge = 0;
  std::uint32_t stamp = 0;

  friend bool operator>(const Candidate& a, const Candidate& b) {
    if (a.relative_length != b.relative_length) return a.relative_length > b.relative_length;
    return a.half_edge != b.half_edge ? a.half_edge > b.half_edge : a.stamp > b.stamp;
  }
};

/// Position, normal and edge length of a vertex.
struct Placement {
  Vec3d position, normal;
  double size = 0;
};

class Remesher {
 public:
  Remesher(const Flesh& flesh, RawMesh raw)
      : flesh_(flesh),
        mesh_(raw.triangles, static_cast<std::uint32_t>(raw.positions.size())),
        positions_(std::move(raw.positions)),
        normals_(positions_.size()),
        sizes_(positions_.size()),
        stamps_(positions_.size()) {
    for (std::uint32_t v = 0; v < positions_.size(); ++v) put(v, placement_at(positions_[v]));
  }

  RawMesh run(std::uint32_t triangle_count) {
    while (mesh_.triangle_count() > triangle_count && strictness_ > kLeastStrictness) {
      const std::uint32_t aim = std::max(triangle_count, mesh_.triangle_count() / 2 / 2 * 2);
      collapse_to(aim);
      if (mesh_.triangle_count() > aim) strictness_ *= 0.7;
      relax();
    }
    PELT_ASSERT(mesh_.triangle_count() == triangle_count);
    for (int i = 1; i < kRelaxations; ++i) relax();
    return compact();
  }

 private:
  Placement placement_at(const Vec3d& position) const;
  Placement placement_near(Vec3d position) const;
  void put(std::uint32_t v, const Placement& placement);

  Candidate candidate(std::uint32_t h) const;
  void collapse_to(std::uint32_t triangle_count);
  bool try_collapse(std::uint32_t h);
  bool survives(std::uint32_t v, std::uint32_t other, const Placement& placement) const;

  void relax();
  void flip_edges();
  bool flip_improves(std::uint32_t h) const;
  void even_out();

  RawMesh compact() const;

  const Flesh& flesh_;
  SurfaceMesh mesh_;
  std::vector<Vec3d> positions_;       // [vertices] on the surface
  std::vector<Vec3d> normals_;         // [vertices] of the surface
  std::vector<double> sizes_;          // [vertices] desired edge lengths, up to a common factor
  std::vector<std::uint32_t> stamps_;  // [vertices] number of changes of the vertex
  double strictness_ = 1;              // required goodness; lowered if no edge can be collapsed
};

/// 1 for an equilateral triangle, 0 for a collapsed one: 4 sqrt(3) area / sum of squared edges.
double shape(const std::array<Vec3d, 3>& c) {
  const Vec3d u = c[1] - c[0], v = c[2] - c[0], w = c[2] - c[1];
  const double squares = squared_length(u) + squared_length(v) + squared_length(w);
  return squares > 0 ? 3.4641016151377544 * length(cross(u, v)) / squares : 0;
}

/// At least 1 for a well-shaped triangle that faces along `normal`.
double goodness(const std::array<Vec3d, 3>& c, const Vec3d& normal) {
  const Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
  const double lengths = length(n) * length(normal);
  const double facing = lengths > 0 ? dot(n, normal) / lengths : 0;
  return std::min(shape(c) / kWorstShape, facing / kLeastFacing);
}

/// Cotangent of the angle at `apex`.
double cotangent(const Vec3d& apex, const Vec3d& a, const Vec3d& b) {
  const Vec3d u = a - apex, v = b - apex;
  return dot(u, v) / std::max(1e-300, length(cross(u, v)));
}

// Edge lengths grow with the square root of the thickness: fingers keep their shape with few
// triangles, and the belly still gets enough.
Placement placed(const Vec3d& position, const FleshSample& sample) {
  return {position, unit(sample.gradient), std::sqrt(sample.thickness)};
}

Placement Remesher::placement_at(const Vec3d& position) const {
  return placed(position, sample_flesh(flesh_, position));
}

Placement Remesher::placement_near(Vec3d position) const {
  const FleshSample sample = project_on_flesh(flesh_, position);
  return placed(position, sample);
}

void Remesher::put(std::uint32_t v, const Placement& placement) {
  positions_[v] = placement.position;
  normals_[v] = placement.normal;
  sizes_[v] = placement.size;
}

Candidate Remesher::candidate(std::uint32_t h) const {
  const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
  const double relative = length(positions_[b] - positions_[a]) / (sizes_[a] + sizes_[b]);
  return {relative, h, stamps_[a] + stamps_[b]};
}

void Remesher::collapse_to(std::uint32_t triangle_count) {
  std::vector<Candidate> edges;
  for (std::uint32_t h = 0; h < mesh_.half_edge_count(); ++h) {
    if (mesh_.is_live_half_edge(h) && h < mesh_.twin(h)) edges.push_back(candidate(h));
  }
  std::priority_queue queue(std::greater<Candidate>(), std::move(edges));
  while (mesh_.triangle_count() > triangle_count && !queue.empty()) {
    const Candidate edge = queue.top();
    queue.pop();
    const std::uint32_t h = edge.half_edge;
    if (!mesh_.is_live_half_edge(h) || candidate(h).stamp != edge.stamp) continue;
    const std::uint32_t a = mesh_.origin(h);
    if (!try_collapse(h)) continue;
    mesh_.for_each_outgoing(a, [&](std::uint32_t from_a) { queue.push(candidate(from_a)); });
  }
}

bool Remesher::try_collapse(std::uint32_t h) {
  const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
  if (mesh_.valence(a) + mesh_.valence(b) > kMaxValence + 4 || !mesh_.can_collapse(h)) return false;
  // The midpoint is near enough to the surface until the mesh is relaxed.
  const Placement placement = {mix(positions_[a], positions_[b], 0.5),
                               unit(normals_[a] + normals_[b]), (sizes_[a] + sizes_[b]) / 2};
  if (!survives(a, b, placement) || !survives(b, a, placement)) return false;
  mesh_.collapse(h);
  put(a, placement);
  stamps_[a] += stamps_[b] + 1;
  return true;
}

/// Whether all triangles at `v`, except those with `other`, stay good or improve if it moves.
bool Remesher::survives(std::uint32_t v, std::uint32_t other, const Placement& placement) const {
  bool good = true;
  mesh_.for_each_outgoing(v, [&](std::uint32_t h) {
    const std::uint32_t b = mesh_.target(h), c = mesh_.origin(SurfaceMesh::previous(h));
    if (!good || b == other || c == other) return;
    const Vec3d &pb = positions_[b], &pc = positions_[c];
    const Vec3d normals = normals_[b] + normals_[c];
    const double after = goodness({placement.position, pb, pc}, placement.normal + normals);
    good = after >= strictness_ || after > goodness({positions_[v], pb, pc}, normals_[v] + normals);
  });
  return good;
}

void Remesher::relax() {
  flip_edges();
  even_out();
}

void Remesher::flip_edges() {
  for (std::uint32_t h = 0; h < mesh_.half_edge_count(); ++h) {
    if (mesh_.is_live_half_edge(h) && h < mesh_.twin(h) && flip_improves(h)) mesh_.flip(h);
  }
}

// The Delaunay rule: flip an edge if its opposite angles sum to more than half a turn.
bool Remesher::flip_improves(std::uint32_t h) const {
  const std::uint32_t g = mesh_.twin(h);
  const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
  const std::uint32_t left = mesh_.origin(SurfaceMesh::previous(h));
  const std::uint32_t right = mesh_.origin(SurfaceMesh::previous(g));
  const Vec3d &pa = positions_[a], &pb = positions_[b];
  const Vec3d &pl = positions_[left], &pr = positions_[right];
  if (cotangent(pl, pa, pb) + cotangent(pr, pa, pb) > -1e-6) return false;
  const Vec3d sides = normals_[left] + normals_[right];
  return goodness({pr, pl, pa}, sides + normals_[a]) >= strictness_ &&
         goodness({pl, pr, pb}, sides + normals_[b]) >= strictness_ && mesh_.can_flip(h);
}

void Remesher::even_out() {
  for (std::uint32_t v = 0; v < positions_.size(); ++v) {
    if (!mesh_.is_live_vertex(v)) continue;
    Vec3d sum;
    double count = 0;
    mesh_.for_each_outgoing(v, [&](std::uint32_t h) {
      sum = sum + positions_[mesh_.target(h)];
      count += 1;
    });
    const Vec3d way = (1 / count) * sum - positions_[v];
    const Vec3d along = way - dot(way, normals_[v]) * normals_[v];
    const Placement placement = placement_near(positions_[v] + 0.7 * along);
    if (survives(v, v, placement)) put(v, placement);
  }
}

RawMesh Remesher::compact() const {
  RawMesh result;
  std::vector<std::uint32_t> number(positions_.size());
  for (std::uint32_t v = 0; v < positions_.size(); ++v) {
    if (!mesh_.is_live_vertex(v)) continue;
    number[v] = static_cast<std::uint32_t>(result.positions.size());
    result.positions.push_back(positions_[v]);
  }
  result.triangles = mesh_.live_triangles();
  for (Triangle& triangle : result.triangles) {
    for (std::uint32_t& v : triangle) v = number[v];
  }
  return result;
}

}  // namespace

RawMesh remesh(const Flesh& flesh, RawMesh raw, std::uint32_t triangle_count) {
  PELT_ASSERT(triangle_count % 2 == 0 && triangle_count <= raw.triangles.size());
  return Remesher(flesh, std::move(raw)).run(triangle_count);
}

}  // namespace pelt::scenes
