#include "self/pair_masks.hpp"

#include <algorithm>
#include <utility>

namespace pelt::detail {
namespace {

/// Masks cover this number of pairs per triangle. A closed surface has six: triangles share 1.5
/// edges each, and in a fan of six, each triangle has three that are not its neighbours.
constexpr std::uint64_t kMaxPairsPerTriangle = 24;

std::uint64_t pairs_of(std::uint64_t count) { return count * (count - 1) / 2; }

/// A pair of triangles in two clusters. Pairs are sorted as integers: by the clusters.
class PackedPair {
 public:
  PackedPair(std::uint32_t low, std::uint32_t row, std::uint32_t high, std::uint32_t lane)
      : bits_(std::uint64_t{low} << 36 | std::uint64_t{high} << 8 | row << 4 | lane) {}
  explicit PackedPair(std::uint64_t bits) : bits_(bits) {}

  std::uint32_t low() const { return static_cast<std::uint32_t>(bits_ >> 36); }
  std::uint32_t high() const { return static_cast<std::uint32_t>(bits_ >> 8) & 0xFFFFFFF; }
  std::uint32_t row() const { return bits_ >> 4 & 15; }
  std::uint32_t lane() const { return bits_ & 15; }
  std::uint64_t bits() const { return bits_; }

  bool has_clusters_of(const PackedPair& other) const { return (bits_ ^ other.bits_) >> 8 == 0; }

 private:
  std::uint64_t bits_;
};

/// Finds the clusters of triangles.
class Clusters {
 public:
  explicit Clusters(const Tree& tree) : tree_(tree), cluster_of_(tree.triangle_count()) {
    for (std::uint32_t c = 0; c < tree.clusters.size(); ++c)
      for (std::uint32_t i = 0; i < tree.clusters[c].triangle_count; ++i)
        cluster_of_[tree.clusters[c].first_triangle + i] = c;
  }

  std::uint32_t of(std::uint32_t place) const { return cluster_of_[place]; }

  PackedPair pair(std::uint32_t s, std::uint32_t t) const {
    if (t < s) std::swap(s, t);
    return {of(s), s - first(s), of(t), t - first(t)};
  }

 private:
  std::uint32_t first(std::uint32_t place) const {
    return tree_.clusters[of(place)].first_triangle;
  }

  const Tree& tree_;
  std::vector<std::uint32_t> cluster_of_;  // [T] by place
};

/// Returns the fans that masks cover: as many as possible, small ones first.
std::vector<std::uint32_t> choose_fans(const Fans& fans, std::uint64_t triangle_count) {
  std::vector<std::uint64_t> by_size;  // the size, and the fan
  for (std::uint32_t fan = 0; fan < fans.count(); ++fan)
    by_size.push_back(std::uint64_t{fans[fan].size()} << 32 | fan);
  std::sort(by_size.begin(), by_size.end());
  std::vector<std::uint32_t> chosen;
  std::uint64_t pairs = 0;
  for (const std::uint64_t fan : by_size) {
    pairs += pairs_of(fan >> 32);
    if (pairs > kMaxPairsPerTriangle * triangle_count + pairs_of(kMaxFan)) break;
    chosen.push_back(static_cast<std::uint32_t>(fan));
  }
  return chosen;
}

/// Returns the bits of packed pairs.
std::vector<std::uint64_t> sharing_pairs(const Fans& fans, const std::vector<std::uint32_t>& chosen,
                                         const Clusters& clusters) {
  std::vector<std::uint64_t> pairs;
  for (const std::uint32_t fan : chosen) {
    const auto triangles = fans[fan];
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        pairs.push_back(clusters.pair(triangles[i].place(), triangles[j].place()).bits());
  }
  return pairs;
}

/// Adds the pairs within each cluster that must not be tested twice.
void add_lower_halves(const Tree& tree, std::vector<std::uint64_t>& pairs) {
  for (std::uint32_t c = 0; c < tree.clusters.size(); ++c)
    for (std::uint32_t s = 0; s < tree.clusters[c].triangle_count; ++s)
      for (std::uint32_t t = 0; t <= s; ++t) pairs.push_back(PackedPair(c, s, c, t).bits());
}

/// Returns for each cluster whether a triangle has a vertex whose fan is not covered.
std::vector<std::uint8_t> mark_hubs(const Tree& tree, const Fans& fans,
                                    const std::vector<std::uint32_t>& covered,
                                    const Clusters& clusters) {
  std::vector<bool> is_covered(fans.count(), false);
  for (const std::uint32_t fan : covered) is_covered[fan] = true;
  std::vector<std::uint8_t> has_hub(tree.clusters.size(), 0);
  for (std::uint32_t fan = 0; fan < fans.count(); ++fan) {
    if (is_covered[fan]) continue;
    for (const FanTriangle& t : fans[fan]) has_hub[clusters.of(t.place())] = 1;
  }
  return has_hub;
}

}  // namespace

PairMasks::PairMasks(const Tree& tree, const Fans& fans) {
  const Clusters clusters(tree);
  const std::vector<std::uint32_t> chosen = choose_fans(fans, tree.triangle_count());
  has_hub = mark_hubs(tree, fans, chosen, clusters);
  std::vector<std::uint64_t> pairs = sharing_pairs(fans, chosen, clusters);
  add_lower_halves(tree, pairs);
  std::sort(pairs.begin(), pairs.end());
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    cluster_nodes.insert(cluster_nodes.end(), tree.nodes[n].cluster_count, n);
  write_masks(pairs, tree.clusters.size());
  write_near_slots(tree);
}

void PairMasks::write_masks(const std::vector<std::uint64_t>& sorted, std::size_t cluster_count) {
  begin.assign(cluster_count + 1, 0);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const PackedPair pair(sorted[i]);
    if (i == 0 || !pair.has_clusters_of(PackedPair(sorted[i - 1]))) {
      masks.emplace_back();
      others.push_back(pair.high());
      ++begin[pair.low() + 1];
    }
    masks.back().set(pair.row(), pair.lane());
  }
  for (std::size_t c = 0; c < cluster_count; ++c) begin[c + 1] += begin[c];
  masks.shrink_to_fit();
  others.shrink_to_fit();
}

void PairMasks::write_near_slots(const Tree& tree) {
  std::vector<std::pair<std::uint64_t, SlotMatrix>>
      pairs;  // both nodes packed, and a pair of slots
  for (std::uint32_t c = 0; c < tree.clusters.size(); ++c)
    for (std::uint32_t i = begin[c] + 1; i < begin[c + 1]; ++i) {
      const std::uint32_t a = cluster_nodes[c], b = cluster_nodes[others[i]];
      pairs.emplace_back(
          std::uint64_t{a} << 32 | b,
          slot_pair(c - tree.nodes[a].first_cluster, others[i] - tree.nodes[b].first_cluster));
    }
  std::sort(pairs.begin(), pairs.end());
  near_begin.assign(tree.nodes.size() + 1, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [nodes, slots] = pairs[i];
    if (i == 0 || pairs[i - 1].first != nodes) {
      near_nodes.push_back(static_cast<std::uint32_t>(nodes));
      near_slots.push_back(0);
      ++near_begin[static_cast<std::uint32_t>(nodes >> 32) + 1];
    }
    near_slots.back() |= slots;
  }
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) near_begin[n + 1] += near_begin[n];
  near_nodes.shrink_to_fit();
  near_slots.shrink_to_fit();
}

void PairMasks::write_mask(const Tree& tree, const Fans& fans, std::uint32_t low,
                           std::uint32_t high, PairMask& mask) const {
  mask = PairMask();
  const Cluster &a = tree.clusters[low], &b = tree.clusters[high];
  for (std::uint32_t s = 0; s < a.triangle_count; ++s)
    for (std::uint32_t t = 0; t < b.triangle_count; ++t)
      if ((low == high && t <= s) ||
          share_corner(fans.corners[a.first_triangle + s], fans.corners[b.first_triangle + t]))
        mask.set(s, t);
}

}  // namespace pelt::detail
