/// Descent of a ray. The node that the ray enters first is opened next. Its clusters are tested
/// before any of its children is opened, because a hit may make that unnecessary.

#include "ray/ray_descent.hpp"

#include "geometry/generic_ray.hpp"
#include "geometry/ray_triangle.hpp"
#include "model/clusters.hpp"
#include "pose/open_node.hpp"
#include "query/answers.hpp"
#include "query/slots.hpp"
#include "ray/ray_triage.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// A triangle hit by the ray.
struct Found {
  std::uint32_t place;
  TriangleCorners corners;
  RayCrossing crossing;
};

RayHit complete(const Tree& tree, const RayLine& line, const Found& found) {
  RayHit hit;
  hit.triangle = tree.triangle_ids[found.place];
  hit.location = Access::location<1>({found.place});
  hit.t = found.crossing.t;
  hit.barycentrics = crossing_weights(line, found.corners, found.crossing);
  hit.normal = unit_normal(found.corners);
  return hit;
}

/// Stores the hit with the least t; among equal ones, the hit of the lowest triangle.
class FirstHit {
 public:
  explicit FirstHit(const Tree& tree) : tree_(tree) {}

  /// Adds a hit. Returns the t beyond which nothing counts any more.
  float take(const Found& found) {
    const float t = found.crossing.t;
    if (!any_ || t < best_.crossing.t || (t == best_.crossing.t && id(found) < id(best_)))
      best_ = found;
    any_ = true;
    return best_.crossing.t;
  }

  bool is_enough() const { return false; }

  RayHit hit(const RayLine& line) const { return any_ ? complete(tree_, line, best_) : RayHit(); }

 private:
  std::uint32_t id(const Found& found) const { return tree_.triangle_ids[found.place]; }

  const Tree& tree_;
  Found best_;
  bool any_ = false;
};

class AnyHit {
 public:
  float take(const Found& found) {
    any_ = true;
    return found.crossing.t;
  }

  bool is_enough() const { return any_; }

 private:
  bool any_ = false;
};

class AllHits {
 public:
  AllHits(const Tree& tree, const Ray& ray, Stack<RayHit>& hits)
      : tree_(tree), line_{ray.origin, ray.direction}, end_(ray.t_max), hits_(hits) {}

  float take(const Found& found) {
    hits_.push(complete(tree_, line_, found));
    return end_;
  }

  bool is_enough() const { return false; }

 private:
  const Tree& tree_;
  RayLine line_;
  float end_;
  Stack<RayHit>& hits_;
};

/// Sums the signs with which the generic ray pierces triangles.
class SignedCrossings {
 public:
  SignedCrossings(const Ray& ray, const GenericDirection& direction)
      : ray_(ray), direction_(direction) {}

  float take(const Found& found) {
    sum_ += pierce_from_back(ray_.origin, direction_, found.corners, found.crossing);
    return ray_.t_max;
  }

  bool is_enough() const { return false; }

  int sum() const { return sum_; }

 private:
  const Ray& ray_;
  const GenericDirection& direction_;
  int sum_ = 0;
};

bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Descent of one ray, with a collector of hits.
template <typename Hits>
class RayDescent {
 public:
  RayDescent(const PosedTree& posed, const RootBox& root, const Ray& ray, Facing facing, Hits& hits,
             QueryStats& work)
      : posed_(posed),
        ray_(ray),
        line_{ray.origin, ray.direction},
        facing_(facing),
        hits_(hits),
        work_(work),
        slabs_(ray, root),
        sheared_(shear(ray.origin, ray.direction)) {}

  /// Runs the descent. Precondition: the ray enters the root's box.
  void run() {
    push(0, -HUGE_VALF);
    while (size_ > 0 && !hits_.is_enough()) {
      const Entered next = entered_[--size_];
      if (slabs_.reaches(next.entry)) visit(posed_.tree.nodes[next.node], next.node);
    }
  }

  bool enters(const RootBox& root) const { return slabs_.enters(root); }

 private:
  struct Entered {
    std::uint32_t node;
    float entry;
  };

  /// Each visit adds at most seven entries.
  static constexpr std::size_t kMaxEntered = kMaxClusterTreeDepth * (kMaxSlots - 1) + 1;

  /// Pushes a node. Entries from `first` on stay sorted, the nearest last.
  void push(std::uint32_t node, float entry, std::size_t first = 0) {
    std::size_t place = size_++;
    for (; place > first && entered_[place - 1].entry < entry; --place)
      entered_[place] = entered_[place - 1];
    entered_[place] = {node, entry};
  }

  void visit(const Node& node, std::uint32_t index) {
    ++work_.node_pairs;
    const OpenedNode& opened = open_node(posed_, index, work_);
    float entries[kMaxSlots];
    const unsigned slots = slabs_.entered(opened, entries) & slots_of(node);
    test_clusters(node, opened, slots & clusters_of(node), entries);
    const std::size_t first = size_;
    for (SetBits slot(slots & ~clusters_of(node)); slot; ++slot)
      if (slabs_.reaches(entries[*slot])) push(child(node, *slot), entries[*slot], first);
  }

  /// Tests clusters, nearest first.
  void test_clusters(const Node& node, const OpenedNode& opened, unsigned clusters,
                     const float (&entries)[kMaxSlots]) {
    while (clusters != 0 && !hits_.is_enough()) {
      SetBits other(clusters);
      unsigned closest = *other;
      for (++other; other; ++other) closest = entries[*other] < entries[closest] ? *other : closest;
      if (!slabs_.reaches(entries[closest])) return;
      clusters &= ~(1u << closest);
      test(posed_.tree.clusters[node.first_cluster + closest], opened.positions);
    }
  }

  void test(const Cluster& cluster, const float* positions) {
    work_.triangle_pairs += cluster.triangle_count;
    for (std::uint32_t first = 0; first < cluster.triangle_count; first += 8) {
      const std::uint32_t left = cluster.triangle_count - first, count = left < 8 ? left : 8;
      test(cluster.first_triangle + first, count, positions);
    }
  }

  /// Returns the corners of eight triangles, padded with those of the first.
  static const std::uint16_t* fill(const std::uint16_t* offsets, std::uint32_t count,
                                   std::uint16_t (&filled)[3 * 8]) {
    for (std::uint32_t i = 0; i < 3 * 8; ++i) filled[i] = offsets[i < 3 * count ? i : i % 3];
    return filled;
  }

  /// Tests up to eight triangles.
  void test(std::uint32_t first, std::uint32_t count, const float* positions) {
    std::uint16_t filled[3 * 8];
    const std::uint16_t* offsets = posed_.tree.corners[first].data();
    if (count < 8) offsets = fill(offsets, count, filled);
    const auto corner = [&](std::uint32_t k) {
      const auto at = [&](std::uint32_t lane) { return load4(positions + offsets[3 * lane + k]); };
      return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
    };
    const RayTriage known = triage(sheared_, corner);
    const unsigned met = known.met_from_front | known.met_from_back;
    for (SetBits lane(((1u << count) - 1) & ~known.missed); lane; ++lane) {
      Found found = {first + *lane, corners_of(first + *lane, positions), {}};
      const bool meets =
          (met >> *lane & 1) != 0
              ? line_pierces_triangle(line_, found.corners,
                                      (known.met_from_front >> *lane & 1) != 0, found.crossing)
              : line_meets_triangle(line_, found.corners, found.crossing);
      if (meets && counts(found.crossing)) slabs_.end_at(hits_.take(found));
    }
  }

  TriangleCorners corners_of(std::uint32_t place, const float* positions) const {
    const std::uint16_t* offsets = posed_.tree.corners[place].data();
    const auto at = [&](int k) {
      const float* p = positions + offsets[k];
      return Vec3{p[0], p[1], p[2]};
    };
    return {at(0), at(1), at(2)};
  }

  bool counts(const RayCrossing& crossing) const {
    return ray_.t_min <= crossing.t && crossing.t <= ray_.t_max &&
           (facing_ == Facing::both || crossing.from_front == (facing_ == Facing::front));
  }

  const PosedTree& posed_;
  const Ray& ray_;
  RayLine line_;
  Facing facing_;
  Hits& hits_;
  QueryStats& work_;
  RaySlabs slabs_;
  ShearedLine sheared_;
  std::size_t size_ = 0;
  Entered entered_[kMaxEntered];  // a stack
};

/// Many rays against one pose. Opening a node on demand takes about seven times as long as opening
/// it as part of all nodes bottom-up, which needs no bounds for the boxes of children. Once rays
/// have opened an eighth of the mesh on demand, and at least as many rays are left, all other nodes
/// are opened. In total, this takes at most twice the time of the better strategy.
struct Batch {
  Batch(const PosedTree& p, std::size_t rays) : posed(p), ray_count(rays) {}

  void has_cast(std::size_t count) {
    if (is_open || ray_count < 2 * count || work.posed_vertices * 8 < posed.tree.vertex_count())
      return;
    is_open = true;
    work += open_all(posed);
  }

  const PosedTree& posed;
  std::size_t ray_count;
  QueryStats work;
  bool is_open = false;
};

/// Passes the hits of the ray to `hits`.
template <typename Hits>
void descend(const PosedTree& posed, const Ray& ray, Facing facing, Hits& hits, QueryStats& work) {
  ++work.node_pairs;
  const RootBox& root = root_box(posed, work);
  const bool has_vertices = root.low[0] <= root.high[0];
  if (!has_vertices || is_zero(ray.direction)) return;
  RayDescent<Hits> descent(posed, root, ray, facing, hits, work);
  if (!descent.enters(root)) return;
  make_table(posed);
  descent.run();
}

}  // namespace

QueryStats first_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                      std::span<RayHit> hits) {
  Batch batch(posed, rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    FirstHit first(posed.tree);
    descend(posed, rays[i], facing, first, batch.work);
    hits[i] = first.hit({rays[i].origin, rays[i].direction});
    batch.has_cast(i + 1);
  }
  return batch.work;
}

QueryStats any_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                    std::span<bool> hit) {
  Batch batch(posed, rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    AnyHit any;
    descend(posed, rays[i], facing, any, batch.work);
    hit[i] = any.is_enough();
    batch.has_cast(i + 1);
  }
  return batch.work;
}

QueryStats all_hits(const PosedTree& posed, const Ray& ray, Facing facing, Stack<RayHit>& hits) {
  QueryStats work;
  AllHits all(posed.tree, ray, hits);
  descend(posed, ray, facing, all, work);
  return work;
}

QueryStats winding_number(const PosedTree& posed, const Vec3& point,
                          const GenericDirection& direction, int& winding) {
  QueryStats work;
  const Ray ray = {point, direction[0]};
  SignedCrossings crossings(ray, direction);
  descend(posed, ray, Facing::both, crossings, work);
  winding = crossings.sum();
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
