#include "rivals/hash_overlap.hpp"

#include "rivals/common_cells.hpp"
#include "rivals/pair_tests.hpp"

namespace pelt::rivals {
namespace {

Box4 box_of(std::span<const NumberedBox> items) {
  Box4 box = detail::empty_box();
  for (const NumberedBox& item : items) box = unite(box, item.box());
  return box;
}

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : triangles_(triangles),
        mean_edge_(rivals::mean_edge(triangles, rest)),
        sides_(rest.size()) {}

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    box_ = detail::empty_box();
    for (std::uint32_t v = 0; v < sides_.size(); ++v)
      box_ = {min(box_.low, points_[v]), max(box_.high, points_[v])};
  }

  /// The triangles whose boxes overlap `where`, their numbers in `first`.
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
  /// The sides of a box beyond which a point lies, one bit each.
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
    if (overlap(bodies_[a].box(), bodies_[b].box())) find_pairs(bodies_[a], bodies_[b], tests);
    return tests.finish();
  }

 private:
  void find_pairs(Body& a, Body& b, PairTests& tests) {
    a.find(intersect(a.box(), b.box()), items_a_);
    b.find(intersect(box_of(items_a_), b.box()), items_b_);
    const Box4 where = intersect(box_of(items_a_), box_of(items_b_));
    if (items_a_.empty() || items_b_.empty()) return;
    cells_.sort(items_a_, items_b_, where,
                options_.cell_edges * std::min(a.mean_edge(), b.mean_edge()));
    for (std::uint32_t j = 0; j < items_b_.size() && !tests.full(); ++j)
      cells_.visit_overlapping(
          j, [&](const NumberedBox& item) { tests.add(item.first, items_b_[j].first); });
  }

  HashOptions options_;
  std::vector<Body> bodies_;
  std::vector<NumberedBox> items_a_, items_b_;
  CommonCells cells_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options) {
  return std::make_unique<HashOverlap>(options);
}

}  // namespace pelt::rivals
