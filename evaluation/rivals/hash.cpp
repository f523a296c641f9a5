/// Teschner, Heidelberger, Mueller, Pomeranets & Gross 2003, "Optimized spatial hashing for
/// collision detection of deformable objects", section 4. Every update enters the boxes of a body's
/// triangles into all cells of a grid that they touch. The cell (i, j, k) is at index (i 73856093
/// xor j 19349663 xor k 83492791) mod n of a table. The triangles of another body are looked up
/// there.
///
/// Strengthened: entries store their cell, so entries of other cells at the same index are skipped
/// without testing their boxes; n is a power of two and at least twice the number of triangles;
/// bodies whose boxes do not overlap are not looked up, nor are triangles outside the other body's
/// box; a body is entered when another is first looked up in it, so only one body of a pair is
/// entered.

#include "evaluation/rivals/cell_grid.hpp"
#include "evaluation/rivals/pair_tests.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"

#include <optional>

namespace pelt::rivals {
namespace {

class HashedBody {
 public:
  HashedBody(std::span<const Triangle> triangles, float cell_edge)
      : triangles_(triangles), cell_edge_(cell_edge), table_(triangles.size()) {
    boxes_.resize(triangles.size());
  }

  void update(std::span<const Vec3> positions) {
    points_ = Points(positions);
    box_ = box_of(points_, static_cast<std::uint32_t>(positions.size()));
    has_boxes_ = is_entered_ = false;
  }

  /// Adds the pairs of this body's triangles and another body's triangles whose boxes overlap.
  void find_pairs(HashedBody& other, PairTests& tests) {
    if (!overlap(box_, other.box_)) return;
    enter_all();
    other.take_boxes();
    for (std::uint32_t t = 0; t < other.boxes_.size() && !tests.full(); ++t)
      if (overlap(other.boxes_[t], box_)) look_up(other.boxes_[t], t, tests);
  }

  PosedMesh mesh() const { return {triangles_.data(), points_.data()}; }

 private:
  void take_boxes() {
    if (has_boxes_) return;
    for (std::size_t t = 0; t < boxes_.size(); ++t) boxes_[t] = points_.box_of(triangles_[t]);
    has_boxes_ = true;
  }

  void enter_all() {
    if (is_entered_) return;
    take_boxes();
    table_.clear();
    large_.clear();
    grid_ = endless_grid(box_.low, cell_edge_);
    for (std::uint32_t t = 0; t < boxes_.size(); ++t) enter(t);
    is_entered_ = true;
  }

  void enter(std::uint32_t t) {
    const CellRange cells = grid_.cells_of(boxes_[t]);
    if (cells.count() > kMaxCells)
      large_.push_back(t);
    else
      cells.visit([&](const Cell& cell) { table_.add(cell, t); });
  }

  void look_up(const Box4& box, std::uint32_t other, PairTests& tests) const {
    const CellRange cells = grid_.cells_of(box);
    if (cells.count() > kMaxCells) {
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
  std::vector<std::uint32_t> large_;             // triangles that touch too many cells
  bool has_boxes_ = false, is_entered_ = false;  // since the last update
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

namespace {

// Spatial hashing (hash.cpp) as its authors intend it: one grid for all bodies. The first query
// after an update finds the contacts of all bodies: for one body after the other, looks up its
// triangles among those of the bodies before it, then enters them. Leaves out triangles outside
// all other bodies' boxes. Queries no pair of bodies separately, and needs no list of near pairs.
// Limits on contacts work, but save little. Precondition of a query: all bodies have been updated.

struct Body {
  std::span<const Triangle> triangles;
  std::uint32_t first_item;  // index of its first triangle among those of all bodies
  std::uint32_t vertex_count;
  Points points;

  PosedMesh mesh() const { return {triangles.data(), points.data()}; }
};

/// A triangle of a body, by its index among those of all bodies.
struct Item {
  Box4 box;
  std::uint32_t body;
  bool is_near;  // to the box of another body
};

/// Overlapping boxes: of a triangle of an earlier body and a triangle of a later one.
struct Candidate {
  std::uint32_t early, late;  // bodies
  Contact triangles;
};

class HashCrowd final : public PosedMeshMethod {
 public:
  explicit HashCrowd(const HashOptions& options) : options_(options) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    const auto first = static_cast<std::uint32_t>(items_.size());
    const auto body = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back({triangles, first, static_cast<std::uint32_t>(rest.size()), Points(rest)});
    items_.resize(items_.size() + triangles.size(), {detail::empty_box(), body, false});
    const float edge = options_.cell_edges * mean_edge(triangles, rest);
    cell_edge_ = body == 0 ? edge : std::min(cell_edge_, edge);
    table_.emplace(items_.size());
    is_searched_ = false;
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body].points = Points(positions);
    is_searched_ = false;
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    if (!is_searched_) search();
    const bool in_order = a < b;
    const std::span<const Candidate> found = in_order ? candidates_of(a, b) : candidates_of(b, a);
    PairTests tests(bodies_[a].mesh(), bodies_[b].mesh(), contacts, max_contacts);
    for (const Candidate& pair : found) {
      const auto [first, second] = pair.triangles;
      in_order ? tests.add(first, second) : tests.add(second, first);
      if (tests.full()) break;
    }
    return tests.finish();
  }

 private:
  void search() {
    take_boxes();
    table_->clear();
    large_.clear();
    candidates_.clear();
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
      visit_items(body, [&](std::uint32_t item) {
        if (items_[item].is_near) look_up(item);
      });
      visit_items(body, [&](std::uint32_t item) {
        if (items_[item].is_near) enter(item);
      });
    }
    std::sort(candidates_.begin(), candidates_.end(), comes_before);
    is_searched_ = true;
  }

  void take_boxes() {
    Box4 all = detail::empty_box();
    boxes_.clear();
    for (const Body& body : bodies_) {
      boxes_.push_back(box_of(body.points, body.vertex_count));
      all = unite(all, boxes_.back());
    }
    grid_ = endless_grid(all.low, cell_edge_);
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) take_boxes_of(body);
  }

  void take_boxes_of(std::uint32_t body) {
    near_.clear();
    for (std::uint32_t other = 0; other < bodies_.size(); ++other)
      if (other != body && overlap(boxes_[body], boxes_[other])) near_.push_back(boxes_[other]);
    const Body& of = bodies_[body];
    visit_items(body, [&](std::uint32_t i) {
      Item& item = items_[i];
      item.box = of.points.box_of(of.triangles[i - of.first_item]);
      item.is_near = std::any_of(near_.begin(), near_.end(),
                                 [&](const Box4& box) { return overlap(item.box, box); });
    });
  }

  template <typename Visit>
  void visit_items(std::uint32_t body, const Visit& visit) const {
    const std::uint32_t first = bodies_[body].first_item;
    for (std::uint32_t i = first; i < first + bodies_[body].triangles.size(); ++i) visit(i);
  }

  void enter(std::uint32_t item) {
    const CellRange cells = grid_.cells_of(items_[item].box);
    if (cells.count() > kMaxCells)
      large_.push_back(item);
    else
      cells.visit([&](const Cell& cell) { table_->add(cell, item); });
  }

  /// Looks up the item among those of the bodies before its own.
  void look_up(std::uint32_t item) {
    const Box4& box = items_[item].box;
    const CellRange cells = grid_.cells_of(box);
    if (cells.count() > kMaxCells) {
      for (std::uint32_t i = 0; i < bodies_[items_[item].body].first_item; ++i) compare(i, item);
      return;
    }
    for (const std::uint32_t large : large_) compare(large, item);
    cells.visit([&](const Cell& cell) {
      table_->visit(cell, [&](std::uint32_t early) {
        if (grid_.is_first_common_cell(cell, items_[early].box, box)) compare(early, item);
      });
    });
  }

  void compare(std::uint32_t early, std::uint32_t late) {
    const Item &e = items_[early], &l = items_[late];
    if (!overlap(e.box, l.box)) return;
    candidates_.push_back(
        {e.body, l.body, {early - bodies_[e.body].first_item, late - bodies_[l.body].first_item}});
  }

  static bool comes_before(const Candidate& c, const Candidate& d) {
    return c.early != d.early ? c.early < d.early : c.late < d.late;
  }

  std::span<const Candidate> candidates_of(std::uint32_t early, std::uint32_t late) const {
    const auto [begin, end] = std::equal_range(candidates_.begin(), candidates_.end(),
                                               Candidate{early, late, {}}, comes_before);
    return {begin, end};
  }

  HashOptions options_;
  float cell_edge_ = 0;
  std::vector<Body> bodies_;
  std::vector<Item> items_;  // triangles, body by body
  std::vector<Box4> boxes_;  // by body
  std::vector<Box4> near_;   // boxes that overlap the box of a body
  std::optional<CellTable> table_;
  CellGrid grid_;
  std::vector<std::uint32_t> large_;  // items that touch too many cells
  std::vector<Candidate> candidates_;
  bool is_searched_ = false;
};

}  // namespace

std::unique_ptr<PosedMeshMethod> make_hash_crowd(const HashOptions& options) {
  return std::make_unique<HashCrowd>(options);
}

}  // namespace pelt::rivals
