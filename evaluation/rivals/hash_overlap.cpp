/// Spatial hashing (hash.cpp) restricted to the overlap of two bodies. An update enters nothing. A
/// query selects the triangles of both bodies that reach into the intersection of the bodies'
/// boxes, finds the cells of the intersection that both bodies touch (CommonCells), and sorts
/// one body's triangles into these cells by counting. There are no chains, no hash, and no table
/// larger than the sorted triangles. If one contact suffices, the query processes the intersection
/// slab by slab and stops at the first slab with a contact; a pair that lies in two slabs is
/// harmless then.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include "evaluation/rivals/cell_grid.hpp"
#include "evaluation/rivals/pair_tests.hpp"

namespace pelt::rivals {
namespace {

Box4 box_of(std::span<const NumberedBox> items) {
  Box4 box = detail::empty_box();
  for (const NumberedBox& item : items) box = unite(box, item.box());
  return box;
}

constexpr std::uint32_t kSlabs = 8;

/// `v` with another value in one lane.
Float4 with(const Float4& v, int lane, float value) {
  const auto at = [&](int i) { return i == lane ? value : v[i]; };
  return {at(0), at(1), at(2), 0};
}

/// Cuts a box into slabs across its longest edge.
std::array<Box4, kSlabs> slabs_of(const Box4& box) {
  const Float4 extent = box.high - box.low;
  const int longest_xy = extent[0] < extent[1] ? 1 : 0;
  const int axis = extent[longest_xy] < extent[2] ? 2 : longest_xy;
  std::array<Box4, kSlabs> slabs;
  slabs.fill(box);
  for (std::size_t i = 1; i < kSlabs; ++i) {
    const float share = static_cast<float>(i) / kSlabs;
    const float cut = (1 - share) * box.low[axis] + share * box.high[axis];
    slabs[i - 1].high = with(box.high, axis, cut);
    slabs[i].low = with(box.low, axis, cut);
  }
  return slabs;
}

void keep_overlapping(std::span<const NumberedBox> items, const Box4& box,
                      std::vector<NumberedBox>& kept) {
  kept.clear();
  for (const NumberedBox& item : items)
    if (overlap(item.box(), box)) kept.push_back(item);
}

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : triangles_(triangles),
        mean_edge_(rivals::mean_edge(triangles, rest)),
        sides_(rest.size()) {}

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    box_ = rivals::box_of(points_, static_cast<std::uint32_t>(sides_.size()));
  }

  /// Appends the triangles whose boxes overlap `where`, with their numbers in `first`.
  void find(const Box4& where, std::vector<NumberedBox>& found) {
    for (std::uint32_t v = 0; v < sides_.size(); ++v) sides_[v] = sides_of(points_[v], where);
    found.clear();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& v = triangles_[t];
      if (sides_[v[0]] & sides_[v[1]] & sides_[v[2]]) continue;
      found.push_back({{}, t, {}, 0});
      found.back().set_box(points_.box_of(v));
    }
  }

  const Box4& box() const { return box_; }
  float mean_edge() const { return mean_edge_; }
  PosedMesh mesh() const { return {triangles_.data(), points_.data()}; }

 private:
  /// The sides of a box beyond which a point is, one bit each.
  static std::uint8_t sides_of(const Float4& p, const Box4& box) {
    return static_cast<std::uint8_t>((p < box.low).bits() % 8 | (box.high < p).bits() % 8 << 3);
  }

  std::span<const Triangle> triangles_;
  float mean_edge_;
  std::vector<std::uint8_t> sides_;  // by vertex
  Points points_;
  Box4 box_ = detail::empty_box();
};

class HashOverlap final : public PosedMeshMethod {
 public:
  explicit HashOverlap(const HashOptions& options) : options_(options) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.emplace_back(triangles, rest);
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body].update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    PairTests tests(bodies_[a].mesh(), bodies_[b].mesh(), contacts, max_contacts);
    if (overlap(bodies_[a].box(), bodies_[b].box()))
      find_pairs(bodies_[a], bodies_[b], max_contacts == 1, tests);
    return tests.finish();
  }

 private:
  void find_pairs(Body& a, Body& b, bool wants_one, PairTests& tests) {
    a.find(intersect(a.box(), b.box()), items_a_);
    b.find(intersect(box_of(items_a_), b.box()), items_b_);
    const float edge = options_.cell_edges * std::min(a.mean_edge(), b.mean_edge());
    if (!wants_one) return add_pairs(items_a_, items_b_, edge, tests);
    for (const Box4& slab : slabs_of(intersect(box_of(items_a_), box_of(items_b_)))) {
      keep_overlapping(items_a_, slab, slab_a_);
      keep_overlapping(items_b_, slab, slab_b_);
      add_pairs(slab_a_, slab_b_, edge, tests);
      if (tests.full()) return;
    }
  }

  /// Adds the overlapping pairs of boxes of both sets. Pending pairs are tested at the end.
  void add_pairs(std::span<const NumberedBox> a, std::span<const NumberedBox> b, float edge,
                 PairTests& tests) {
    const Box4 box_a = box_of(a), box_b = box_of(b);
    if (!overlap(box_a, box_b)) return;
    cells_.sort(a, b, intersect(box_a, box_b), edge);
    for (std::uint32_t j = 0; j < b.size() && !tests.full(); ++j)
      cells_.visit_overlapping(j,
                               [&](const NumberedBox& item) { tests.add(item.first, b[j].first); });
    tests.test();
  }

  HashOptions options_;
  std::vector<Body> bodies_;
  std::vector<NumberedBox> items_a_, items_b_, slab_a_, slab_b_;
  CommonCells cells_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options) {
  return std::make_unique<HashOverlap>(options);
}

}  // namespace pelt::rivals
