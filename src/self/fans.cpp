#include "self/fans.hpp"

#include "base/assert.hpp"
#include "model/unpack.hpp"
#include "model/weld.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

/// Returns the surface vertices of all corners, and marks those that are split into several
/// vertices of the caller, which can move apart: they have different influences, or are not welded
/// because the caller gives them positions or offsets of their own.
std::vector<std::array<std::uint32_t, 3>> surface_corners(const Tree& tree,
                                                          std::vector<bool>& is_split) {
  const SkinnedMesh vertices = unpack_vertices(tree);
  const std::vector<std::uint32_t> surface = weld_surface(vertices);
  const std::vector<std::uint32_t>& callers = tree.place_vertices;
  is_split.assign(surface.size(), false);
  for (std::size_t place = 0; place < surface.size(); ++place)
    if (callers[place] != callers[surface[place]]) is_split[surface[place]] = true;

  std::vector<std::array<std::uint32_t, 3>> corners(tree.corners.size());
  for (const Node& node : tree.nodes)
    for (std::uint32_t c = node.first_cluster; c < node.first_cluster + node.cluster_count; ++c) {
      const std::uint32_t first = tree.clusters[c].first_triangle;
      for (std::uint32_t t = first; t < first + tree.clusters[c].triangle_count; ++t)
        for (std::size_t k = 0; k < 3; ++k)
          corners[t][k] = surface[node.first_vertex + tree.corners[t][k] / kFloatsPerVertex];
    }
  return corners;
}

/// The triangles around one surface vertex.
class FanBuilder {
 public:
  FanBuilder(const std::vector<std::array<std::uint32_t, 3>>& corners,
             const std::vector<bool>& is_split)
      : corners_(corners), is_split_(is_split) {}

  /// Determines the kind of a fan, and orders its triangles.
  FanKind order(std::span<FanTriangle> fan) const {
    for (const FanTriangle& triangle : fan)
      for (const std::uint32_t vertex : corners_[triangle.place()])
        if (is_split_[vertex]) return FanKind::cracked;
    if (fan.size() > kMaxFan) return FanKind::complex;
    return is_chained(fan) ? kind_of_chain(fan) : FanKind::complex;
  }

 private:
  /// The corner after the fan's vertex, counter-clockwise, and the corner before.
  std::uint32_t after(const FanTriangle& t) const {
    return corners_[t.place()][(t.corner() + 1) % 3];
  }
  std::uint32_t before(const FanTriangle& t) const {
    return corners_[t.place()][(t.corner() + 2) % 3];
  }

  /// Moves a triangle with no neighbour before it to the front, if there is one.
  void bring_start(std::span<FanTriangle> fan) const {
    for (FanTriangle& candidate : fan) {
      const auto is_neighbour = [&](const FanTriangle& t) { return before(t) == after(candidate); };
      if (std::any_of(fan.begin(), fan.end(), is_neighbour)) continue;
      std::swap(candidate, fan[0]);
      return;
    }
  }

  /// Orders the triangles so that each shares the edge with the next, if possible.
  bool is_chained(std::span<FanTriangle> fan) const {
    bring_start(fan);
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
      const auto next =
          std::find_if(fan.begin() + static_cast<std::ptrdiff_t>(i) + 1, fan.end(),
                       [&](const FanTriangle& t) { return after(t) == before(fan[i]); });
      if (next == fan.end()) return false;
      std::swap(*next, fan[i + 1]);
    }
    return has_distinct_spokes(fan);
  }

  /// Whether no edge belongs to more than two triangles, and no triangle has equal corners.
  bool has_distinct_spokes(std::span<const FanTriangle> fan) const {
    std::array<std::uint32_t, kMaxFan + 2> spokes;
    std::size_t count = 0;
    spokes[count++] = corners_[fan[0].place()][fan[0].corner()];
    for (const FanTriangle& t : fan) spokes[count++] = after(t);
    if (before(fan.back()) != after(fan[0])) spokes[count++] = before(fan.back());
    std::sort(spokes.begin(), spokes.begin() + count);
    return std::adjacent_find(spokes.begin(), spokes.begin() + count) == spokes.begin() + count;
  }

  FanKind kind_of_chain(std::span<const FanTriangle> fan) const {
    return before(fan.back()) == after(fan[0]) ? FanKind::closed : FanKind::open;
  }

  const std::vector<std::array<std::uint32_t, 3>>& corners_;
  const std::vector<bool>& is_split_;
};

/// Returns each triangle with each of its surface vertices, grouped by vertex.
std::vector<FanTriangle> group_by_vertex(const std::vector<std::array<std::uint32_t, 3>>& corners,
                                         std::vector<std::uint32_t>& begin) {
  std::uint32_t vertex_count = 0;
  for (const auto& triangle : corners)
    for (const std::uint32_t vertex : triangle) vertex_count = std::max(vertex_count, vertex + 1);
  const auto is_first = [&](std::uint32_t place, std::uint32_t k) {
    const auto& [a, b, c] = corners[place];
    return k == 0 || (k == 1 ? b != a : c != a && c != b);
  };
  begin.assign(vertex_count + 1, 0);
  const auto each = [&](const auto& visit) {
    for (std::uint32_t place = 0; place < corners.size(); ++place)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (is_first(place, k)) visit(place, k);
  };
  each([&](std::uint32_t place, std::uint32_t k) { ++begin[corners[place][k] + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
  std::vector<FanTriangle> triangles(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  each([&](std::uint32_t place, std::uint32_t k) {
    triangles[next[corners[place][k]]++] = FanTriangle(place, k);
  });
  return triangles;
}

/// The triangles of a fan, by their first index and their number. Ranges are sorted as integers: by
/// kind, then by count.
class Range {
 public:
  Range(FanKind kind, std::uint32_t first, std::uint32_t count)
      : bits_(std::uint64_t{static_cast<std::uint8_t>(kind)} << 60 | std::uint64_t{count} << 30 |
              first) {}
  explicit Range(std::uint64_t bits) : bits_(bits) {}

  FanKind kind() const { return static_cast<FanKind>(bits_ >> 60); }
  std::uint32_t count() const { return bits_ >> 30 & kMask; }
  std::uint32_t first() const { return bits_ & kMask; }
  std::uint64_t bits() const { return bits_; }

 private:
  static constexpr std::uint32_t kMask = (std::uint32_t{1} << 30) - 1;
  static_assert(3 * std::uint64_t{kMaxFanTriangles} <= kMask);

  std::uint64_t bits_;
};

}  // namespace

Fans::Fans(const Tree& tree) {
  PELT_ASSERT(tree.triangle_count() <= kMaxFanTriangles);
  std::vector<bool> is_split;
  corners = surface_corners(tree, is_split);
  std::vector<std::uint32_t> vertex_begin;
  std::vector<FanTriangle> grouped = group_by_vertex(corners, vertex_begin);

  const FanBuilder builder(corners, is_split);
  std::vector<std::uint64_t> ranges;
  for (std::size_t v = 0; v + 1 < vertex_begin.size(); ++v) {
    const std::uint32_t first = vertex_begin[v], size = vertex_begin[v + 1] - first;
    if (size == 0) continue;
    const FanKind kind = builder.order(std::span(grouped).subspan(first, size));
    ranges.push_back(Range(kind, first, size).bits());
  }
  std::sort(ranges.begin(), ranges.end());

  triangles.reserve(grouped.size());
  for (const std::uint64_t bits : ranges) {
    const Range range(bits);
    if (runs.empty() || runs.back().kind != range.kind() || runs.back().size != range.count())
      runs.push_back({range.kind(), range.count(), count(), count(),
                      static_cast<std::uint32_t>(triangles.size())});
    ++runs.back().end;
    const auto first = grouped.begin() + range.first();
    triangles.insert(triangles.end(), first, first + range.count());
  }
}

std::uint32_t Fans::flat_count() const {
  std::uint32_t flat = 0;
  for (const FanRun& run : runs)
    if (can_be_flat(run.kind)) flat = run.end;
  return flat;
}

const FanRun& Fans::run_of(std::uint32_t fan) const {
  PELT_ASSERT(fan < count());
  return *std::partition_point(runs.begin(), runs.end(),
                               [fan](const FanRun& run) { return run.end <= fan; });
}

}  // namespace pelt::detail
