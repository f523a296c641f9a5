#include "rivals/hash_overlap.hpp"

#include "rivals/cell_grid.hpp"
#include "rivals/pair_tests.hpp"

#include <cmath>

namespace pelt::rivals {
namespace {

/// A triangle's box and, in `first`, its number.
using Item = NumberedBox;

Box4 box_of(std::span<const Item> items) {
  Box4 box = detail::empty_box();
  for (const Item& item : items) box = unite(box, item.box());
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

  /// The triangles whose boxes overlap `where`.
  void find(const Box4& where, std::vector<Item>& found) {
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

/// Boxes sorted by the cells of a box that they touch.
class SortedCells {
 public:
  void sort(std::span<const Item> items, const Box4& where, float edge) {
    choose_cells(where, edge, items.size());
    large_.clear();
    begin_.assign(sizes_[0] * sizes_[1] * sizes_[2] + 1, 0);
    visit_cells(items, [&](std::uint32_t cell, std::uint32_t) { ++begin_[cell]; });
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begin_) begin = end += begin;
    entries_.resize(end);
    // Each cell's entries are filled in from their end: begin_ falls to where they begin.
    visit_cells(items, [&](std::uint32_t cell, std::uint32_t i) { entries_[--begin_[cell]] = i; });
    for (std::uint32_t i = 0; i < items.size(); ++i)
      if (is_large(grid_.cells_of(items[i].box()))) large_.push_back(i);
  }

  /// Calls `visit(i)` once for each of the sorted boxes that overlaps `box`, all within `where`.
  template <typename Visit>
  void visit_overlapping(std::span<const Item> items, const Box4& box, const Visit& visit) const {
    const auto test = [&](std::uint32_t i) {
      if (overlap(items[i].box(), box)) visit(i);
    };
    const CellRange cells = grid_.cells_of(box);
    if (is_large(cells)) {
      for (std::uint32_t i = 0; i < items.size(); ++i) test(i);
      return;
    }
    for (const std::uint32_t i : large_) test(i);
    cells.visit([&](const Cell& cell) {
      const std::uint32_t c = number_of(cell);
      for (std::uint32_t e = begin_[c]; e < begin_[c + 1]; ++e) {
        const Box4 other = items[entries_[e]].box();
        if (overlap(other, box) && grid_.is_first_common_cell(cell, other, box)) visit(entries_[e]);
      }
    });
  }

 private:
  static bool is_large(const CellRange& cells) { return cells.count() > kMostCells; }

  void choose_cells(const Box4& where, float edge, std::size_t count) {
    const Float4 extent = where.high - where.low;
    const double most = 4.0 * static_cast<double>(count) + 64;
    edge = std::max(edge, std::numeric_limits<float>::min());
    constexpr float kHalfTheCells = 1.26f;  // the cube root of 2
    const auto cells_on = [&](int axis) { return std::floor(extent[axis] / edge) + 1.0; };
    while (cells_on(0) * cells_on(1) * cells_on(2) > most) edge *= kHalfTheCells;
    for (int axis = 0; axis < 3; ++axis) sizes_[axis] = static_cast<std::uint32_t>(cells_on(axis));
    grid_ = CellGrid(where.low, edge, {sizes_[0] - 1, sizes_[1] - 1, sizes_[2] - 1});
  }

  template <typename Visit>
  void visit_cells(std::span<const Item> items, const Visit& visit) const {
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      const CellRange cells = grid_.cells_of(items[i].box());
      if (!is_large(cells)) cells.visit([&](const Cell& cell) { visit(number_of(cell), i); });
    }
  }

  std::uint32_t number_of(const Cell& cell) const {
    return (cell[2] * sizes_[1] + cell[1]) * sizes_[0] + cell[0];
  }

  CellGrid grid_;
  Cell sizes_ = {};
  std::vector<std::uint32_t> begin_;    // by cell, into entries_; and the end
  std::vector<std::uint32_t> entries_;  // boxes, cell after cell
  std::vector<std::uint32_t> large_;    // boxes that touch too many cells
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
    std::erase_if(items_a_, [&](const Item& item) { return !overlap(item.box(), where); });
    if (items_a_.empty() || items_b_.empty()) return;
    cells_.sort(items_a_, where, options_.cell_edges * std::min(a.mean_edge(), b.mean_edge()));
    for (const Item& item : items_b_) {
      if (tests.full()) break;
      cells_.visit_overlapping(items_a_, item.box(),
                               [&](std::uint32_t i) { tests.add(items_a_[i].first, item.first); });
    }
  }

  HashOptions options_;
  std::vector<Body> bodies_;
  std::vector<Item> items_a_, items_b_;
  SortedCells cells_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options) {
  return std::make_unique<HashOverlap>(options);
}

}  // namespace pelt::rivals
