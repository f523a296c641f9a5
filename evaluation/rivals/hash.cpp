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

#include "evaluation/rivals/posed_mesh_method.hpp"

#include "evaluation/rivals/cell_grid.hpp"
#include "evaluation/rivals/pair_tests.hpp"

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

}  // namespace pelt::rivals
