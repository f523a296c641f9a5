#include "volume/winding_spread.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pelt::detail {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

/// An edge of a triangle: three times the place of the triangle, plus the number of the edge.
using Edge = std::uint32_t;

/// An edge by its vertices, the lower one first.
struct NamedEdge {
  std::array<std::uint32_t, 2> vertices;
  Edge edge;

  friend bool operator<(const NamedEdge& a, const NamedEdge& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.edge < b.edge;
  }
};

std::vector<NamedEdge> sorted_edges(const Surface& surface) {
  const std::vector<std::uint32_t>& ids = surface.model.detail().tree.triangle_ids;
  std::vector<NamedEdge> edges;
  edges.reserve(3 * ids.size());
  for (std::uint32_t place = 0; place < ids.size(); ++place) {
    const Triangle& t = surface.corners[ids[place]];
    if (has_repeated_vertex(t)) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back({{low, high}, 3 * place + i});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Returns for each edge [3 T] the opposite one, or kNone for triangles with repeated vertices.
std::vector<Edge> opposite_edges(const Surface& surface) {
  const std::vector<NamedEdge> edges = sorted_edges(surface);
  std::vector<Edge> opposite(3 * surface.corners.size(), kNone);
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    opposite[edges[i].edge] = edges[i + 1].edge;
    opposite[edges[i + 1].edge] = edges[i].edge;
  }
  return opposite;
}

std::vector<SpreadingStep> spreading_steps(const Surface& surface) {
  const std::vector<Edge> opposite = opposite_edges(surface);
  const std::size_t count = surface.corners.size();
  std::vector<SpreadingStep> steps;
  std::vector<bool> is_reached(count, false);
  const auto reach = [&](const SpreadingStep& step) {
    if (!is_reached[step.triangle]) steps.push_back(step);
    is_reached[step.triangle] = true;
  };
  std::size_t next = 0;
  for (std::uint32_t start = 0; start < count; ++start) {
    if (opposite[std::size_t{3} * start] != kNone) reach({start, start});
    for (; next < steps.size(); ++next)
      for (std::uint8_t i = 0; i < 3; ++i) {
        const Edge other = opposite[std::size_t{3} * steps[next].triangle + i];
        reach({other / 3, steps[next].triangle, static_cast<std::uint8_t>(other % 3), i});
      }
  }
  return steps;
}

}  // namespace

WindingSpread::WindingSpread(const Surface& surface)
    : neighbours(surface.model, SelfFilterOptions()), steps(spreading_steps(surface)) {}

const WindingSpread& spread_of(const Surface& surface) {
  std::call_once(surface.spread_is_made,
                 [&] { surface.spread = std::make_shared<const WindingSpread>(surface); });
  return *surface.spread;
}

}  // namespace pelt::detail
