#include "rivals/hash.hpp"

#include "rivals/cell_grid.hpp"
#include "rivals/pair_tests.hpp"

#include <bit>

namespace pelt::rivals {
namespace {

/// The cells of one body, and which of its triangles touch each.
class CellTable {
 public:
  explicit CellTable(std::size_t triangle_count)
      : places_(std::bit_ceil(2 * triangle_count)), mask_(places_.size() - 1) {}

  void clear() {
    entries_.clear();
    if (++stamp_ != 0) return;
    std::fill(places_.begin(), places_.end(), Place{});
    stamp_ = 1;
  }

  void add(const Cell& cell, std::uint32_t triangle) {
    Place& place = places_[place_of(cell)];
    const std::uint32_t next = place.stamp == stamp_ ? place.last_entry : kNone;
    place = {stamp_, static_cast<std::uint32_t>(entries_.size())};
    entries_.push_back({key_of(cell), triangle, next});
  }

  template <typename Visit>
  void visit(const Cell& cell, const Visit& visit) const {
    const Place& place = places_[place_of(cell)];
    if (place.stamp != stamp_) return;
    const std::uint64_t key = key_of(cell);
    for (std::uint32_t e = place.last_entry; e != kNone; e = entries_[e].next)
      if (entries_[e].key == key) visit(entries_[e].triangle);
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;

  struct Place {
    std::uint32_t stamp = 0, last_entry = 0;
  };

  struct Entry {
    std::uint64_t key;
    std::uint32_t triangle, next;
  };

  std::size_t place_of(const Cell& cell) const {
    return (cell[0] * 73856093u ^ cell[1] * 19349663u ^ cell[2] * 83492791u) & mask_;
  }

  static std::uint64_t key_of(const Cell& cell) {
    return cell[0] | std::uint64_t{cell[1]} << 20 | std::uint64_t{cell[2]} << 40;
  }

  std::vector<Place> places_;
  std::size_t mask_;
  std::vector<Entry> entries_;
  std::uint32_t stamp_ = 0;
};

class HashedBody {
 public:
  HashedBody(std::span<const Triangle> triangles, float cell_edge)
      : triangles_(triangles), cell_edge_(cell_edge), table_(triangles.size()) {
    boxes_.resize(triangles.size());
  }

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    take_boxes();
    table_.clear();
    large_.clear();
    constexpr std::uint32_t kLast = CellGrid::kMostOnAxis - 1;
    grid_ = CellGrid(box_.low, cell_edge_, {kLast, kLast, kLast});
    for (std::uint32_t t = 0; t < boxes_.size(); ++t) enter(t);
  }

  /// Adds the pairs of this body's triangles with another's whose boxes overlap.
  void find_pairs(const HashedBody& other, PairTests& tests) const {
    if (!overlap(box_, other.box_)) return;
    for (std::uint32_t t = 0; t < other.boxes_.size() && !tests.full(); ++t)
      if (overlap(other.boxes_[t], box_)) look_up(other.boxes_[t], t, tests);
  }

  PosedMesh mesh() const { return {triangles_.data(), points_.data()}; }

 private:
  void take_boxes() {
    box_ = detail::empty_box();
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      boxes_[t] = points_.box_of(triangles_[t]);
      box_ = unite(box_, boxes_[t]);
    }
  }

  void enter(std::uint32_t t) {
    const CellRange cells = grid_.cells_of(boxes_[t]);
    if (cells.count() > kMostCells)
      large_.push_back(t);
    else
      cells.visit([&](const Cell& cell) { table_.add(cell, t); });
  }

  void look_up(const Box4& box, std::uint32_t other, PairTests& tests) const {
    const CellRange cells = grid_.cells_of(box);
    if (cells.count() > kMostCells) {
      for (std::uint32_t t = 0; t < boxes_.size(); ++t) add_if_overlapping(t, box, other, tests);
      return;
    }
    for (const std::uint32_t t : large_) add_if_overlapping(t, box, other, tests);
    cells.visit([&](const Cell& cell) {
      table_.visit(cell, [&](std::uint32_t t) {
        if (overlap(boxes_[t], box) && grid_.is_first_common_cell(cell, boxes_[t], box))
          tests.add(t, other);
      });
    });
  }

  void add_if_overlapping(std::uint32_t t, const Box4& box, std::uint32_t other,
                          PairTests& tests) const {
    if (overlap(boxes_[t], box)) tests.add(t, other);
  }

  std::span<const Triangle> triangles_;
  float cell_edge_;
  Points points_;
  std::vector<Box4> boxes_;  // by triangle
  Box4 box_ = detail::empty_box();
  CellGrid grid_;
  CellTable table_;
  std::vector<std::uint32_t> large_;  // triangles that touch too many cells
};

class Hash final : public PosedMeshMethod {
 public:
  explicit Hash(const HashOptions& options) : options_(options) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.emplace_back(triangles, options_.cell_edges * mean_edge(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body].update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    PairTests tests(bodies_[a].mesh(), bodies_[b].mesh(), contacts, max_contacts);
    bodies_[a].find_pairs(bodies_[b], tests);
    return tests.finish();
  }

 private:
  HashOptions options_;
  std::vector<HashedBody> bodies_;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hash(const HashOptions& options) {
  return std::make_unique<Hash>(options);
}

}  // namespace pelt::rivals
