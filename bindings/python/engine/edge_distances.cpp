#include "bindings/python/engine/edge_distances.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace pelt::python {
namespace {

struct Edge {
  std::uint32_t to;
  double length;
};

/// The edges that leave each vertex. Edges of two triangles occur twice.
class Edges {
 public:
  Edges(std::span<const Vec3> positions, std::span<const Triangle> faces)
      : begins_(positions.size() + 1), edges_(6 * faces.size()) {
    for (const auto& face : faces)
      for (const std::uint32_t vertex : face) begins_[vertex + 1] += 2;
    for (std::size_t v = 0; v < positions.size(); ++v) begins_[v + 1] += begins_[v];
    std::vector<std::size_t> ends(begins_.begin(), begins_.end() - 1);
    for (const auto& face : faces)
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (const std::size_t other : {(corner + 1) % 3, (corner + 2) % 3})
          edges_[ends[face[corner]]++] = {face[other],
                                          length(positions[face[corner]], positions[face[other]])};
  }

  std::span<const Edge> of(std::uint32_t vertex) const {
    return std::span(edges_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
  }

 private:
  static double length(const Vec3& a, const Vec3& b) {
    return std::hypot(double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z);
  }

  std::vector<std::size_t> begins_;
  std::vector<Edge> edges_;
};

/// The algorithm of Dijkstra, up to a limit. Working memory is used again.
class Search {
 public:
  Search(const Edges& edges, std::size_t vertices, double limit)
      : edges_(edges), limit_(limit), distances_(vertices, kFar) {}

  /// Calls `visit(vertex)` for each vertex nearer than the limit.
  template <class Visit>
  void run(std::uint32_t start, const Visit& visit) {
    reach(start, 0);
    while (!queue_.empty()) {
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      if (distance > distances_[vertex]) continue;
      for (const Edge& edge : edges_.of(vertex)) reach(edge.to, distance + edge.length);
    }
    for (const std::uint32_t vertex : reached_) {
      visit(vertex);
      distances_[vertex] = kFar;
    }
    reached_.clear();
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  void reach(std::uint32_t vertex, double distance) {
    if (distance >= limit_ || distance >= distances_[vertex]) return;
    if (distances_[vertex] == kFar) reached_.push_back(vertex);
    distances_[vertex] = distance;
    queue_.emplace(distance, vertex);
  }

  using Entry = std::pair<double, std::uint32_t>;

  const Edges& edges_;
  double limit_;
  std::vector<double> distances_;
  std::vector<std::uint32_t> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

NearAlongEdges::NearAlongEdges(std::span<const Vec3> positions, std::span<const Triangle> faces,
                               double limit, const Run& run)
    : vertex_count_(positions.size()),
      row_((positions.size() + 63) / 64),
      bits_(vertex_count_ * row_) {
  const Edges edges(positions, faces);
  run_frames(vertex_count_, run, [&](FrameQueue& queue) {
    Search search(edges, vertex_count_, limit);
    while (const auto start = queue.next())
      search.run(static_cast<std::uint32_t>(*start), [&](std::uint32_t vertex) {
        bits_[*start * row_ + vertex / 64] |= std::uint64_t{1} << (vertex % 64);
      });
  });
}

}  // namespace pelt::python
