/// The queries of a pose, of a motion and of rays against a height field.

#include <pelt/height_field.hpp>

#include "base/assert.hpp"
#include "distance/answers.hpp"
#include "distance/distance_search.hpp"
#include "field/field_trees.hpp"
#include "field/height_field.hpp"
#include "geometry/ray_triangle.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "query/valid_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace pelt {
namespace {

using detail::PosedTree;

/// Writes the contacts to `scratch`, in no particular order.
QueryStats find_contacts(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_field(posed, field.detail(), scratch.detail(), max_contacts);
}

MovingStats find_moving(const Motion& motion, const HeightField& field, Scratch& scratch,
                        const MovingOptions& options) {
  return detail::collide_moving_field(detail::step_of(motion).tree(), field.detail(),
                                      scratch.detail(), options);
}

}  // namespace

QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                   std::vector<Contact>& contacts, const Limits& limits) {
  const QueryStats stats =
      find_contacts(pose.detail().posed_tree(), field, scratch, limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch) {
  const QueryStats stats = find_contacts(pose.detail().posed_tree(), field, scratch, 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

MovingStats collide(const Motion& motion, const HeightField& field, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const MovingStats stats = find_moving(motion, field, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(const Motion& motion, const HeightField& field, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return find_moving(motion, field, scratch, options);
  });
}

QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch, Distance& result,
                    const DistanceOptions& options) {
  const PosedTree posed = pose.detail().posed_tree();
  return detail::least_distance(
      scratch.detail(), options, result,
      [&](std::uint32_t most, std::uint64_t) { return find_contacts(posed, field, scratch, most); },
      [&](const Contact& contact, QueryStats& work) {
        const detail::FoundTriangle found = detail::find_triangle(posed, contact.triangle_a, work);
        return detail::distance_touching(contact, found.corners,
                                         field.triangle(contact.triangle_b));
      },
      [&](const detail::SearchLimits& limits, detail::TriangleGap& gap) {
        return detail::closest_field_triangle(posed, field.detail(), scratch.detail(), limits, gap);
      });
}

namespace detail {
namespace {

// Tests a ray against the blocks of a height field, in the order in which the ray enters them, and
// exactly against the triangles of the remaining cells.
//
// Rounding. A block spans t from (low - o) / d to (high - o) / d. In double, each has at most two
// relative errors of 2^-53, and no operation on floats overflows or underflows. Both ends are
// moved outwards by 2^-50 of their values. A hit's t is rounded to float, so a block that ends
// beyond it by a 2^-23rd may still contain an equally near hit.

/// An interval of t.
struct Span {
  double first, last;

  bool is_empty() const { return !(first <= last); }
};

/// Clips `span` to the part of the ray between `low` and `high` on an axis.
void clip(double origin, double direction, double low, double high, Span& span) {
  if (direction == 0) {
    if (!(low <= origin && origin <= high)) span.last = -HUGE_VAL;
    return;
  }
  const double a = (low - origin) / direction, b = (high - origin) / direction;
  const double near = std::min(a, b), far = std::max(a, b);
  span.first = std::max(span.first, near - std::abs(near) * 0x1p-50);
  span.last = std::min(span.last, far + std::abs(far) * 0x1p-50);
}

/// Returns `t`, moved in the direction of `sign` by more than the error of rounding it to float.
double moved(float t, double sign) {
  return double{t} + sign * (std::abs(double{t}) * 0x1p-23 + 0x1p-149);
}

/// Finds the first hit of a ray. Precondition: all numbers of the ray except its ends are finite.
class FieldCast {
 public:
  FieldCast(const HeightField& field, const Ray& ray, Facing facing, QueryStats& work)
      : field_(field),
        ray_(ray),
        line_{ray.origin, ray.direction},
        facing_(facing),
        work_(work),
        span_{moved(ray.t_min, -1), moved(ray.t_max, 1)} {}

  RayHit run() {
    const auto top = static_cast<std::uint32_t>(field_.levels.size()) - 1;
    add({top, 0, 0});
    while (size_ > 0) {
      const Entered next = entered_[--size_];
      if (next.entry <= span_.last) visit(next.block);
    }
    if (hit_) complete();
    return hit_;
  }

 private:
  struct Block {
    std::uint32_t level, column, row;
  };

  struct Entered {
    Block block;
    double entry;
  };

  /// A field has less than 2^32 cells a side, and a visit leaves at most three blocks more.
  static constexpr std::size_t kMaxEntered = 32 * 3 + 1;

  /// The interval in which the ray is above a rectangle of cells and between two heights.
  Span span_in(std::uint32_t column, std::uint32_t last_column, std::uint32_t row,
               std::uint32_t last_row, const HeightRange& heights) const {
    Span span = span_;
    if (!(heights.low <= heights.high)) return {0, -1};
    const Vec3 &o = ray_.origin, &d = ray_.direction;
    clip(o.x, d.x, field_.x[column], field_.x[last_column], span);
    clip(o.y, d.y, heights.low, heights.high, span);
    clip(o.z, d.z, field_.z[row], field_.z[last_row], span);
    return span;
  }

  /// Inserts the block if the ray enters it. Blocks from `first` on stay sorted, nearest last.
  void add(const Block& block, std::size_t first = 0) {
    const FieldLevel& level = field_.levels[block.level];
    if (block.column >= level.columns || block.row >= level.rows) return;
    const std::uint32_t side = 1u << (kBlockShift + block.level);
    const std::uint32_t column = block.column * side, row = block.row * side;
    const Span span = span_in(column, std::min(column + side, field_.columns() - 1), row,
                              std::min(row + side, field_.rows() - 1),
                              level.blocks[std::size_t{block.row} * level.columns + block.column]);
    if (span.is_empty()) return;
    std::size_t place = size_++;
    for (; place > first && entered_[place - 1].entry < span.first; --place)
      entered_[place] = entered_[place - 1];
    entered_[place] = {block, span.first};
  }

  void visit(const Block& block) {
    ++work_.node_pairs;
    if (block.level == 0) return visit_cells(block);
    const std::size_t first = size_;
    for (const std::uint32_t row : {2 * block.row, 2 * block.row + 1})
      for (const std::uint32_t column : {2 * block.column, 2 * block.column + 1})
        add({block.level - 1, column, row}, first);
  }

  void visit_cells(const Block& block) {
    constexpr std::uint32_t kSide = 1u << kBlockShift;
    const std::uint32_t column = block.column * kSide, row = block.row * kSide;
    const std::uint32_t last_column = std::min(column + kSide, field_.columns() - 1);
    const std::uint32_t last_row = std::min(row + kSide, field_.rows() - 1);
    const HeightRange heights =
        field_.levels[0].blocks[std::size_t{block.row} * field_.levels[0].columns + block.column];
    for (std::uint32_t r = row; r < last_row; ++r)
      for (std::uint32_t c = column; c < last_column; ++c)
        if (!span_in(c, c + 1, r, r + 1, heights).is_empty()) test_cell(c, r);
  }

  void test_cell(std::uint32_t column, std::uint32_t row) {
    const std::uint32_t number = 2 * (row * (field_.columns() - 1) + column);
    for (const std::uint32_t triangle : {number, number + 1}) {
      const TriangleCorners corners = field_.triangle(triangle);
      if (is_hole(corners)) continue;
      ++work_.triangle_pairs;
      RayCrossing crossing;
      if (line_meets_triangle(line_, corners, crossing) && counts(crossing))
        take(triangle, crossing);
    }
  }

  static bool is_hole(const TriangleCorners& corners) {
    return std::isnan(corners[0].y) || std::isnan(corners[1].y) || std::isnan(corners[2].y);
  }

  bool counts(const RayCrossing& crossing) const {
    return ray_.t_min <= crossing.t && crossing.t <= ray_.t_max &&
           (facing_ == Facing::both || crossing.from_front == (facing_ == Facing::front));
  }

  void take(std::uint32_t triangle, const RayCrossing& crossing) {
    if (hit_ && (crossing.t > hit_.t || (crossing.t == hit_.t && triangle > hit_.triangle))) return;
    hit_.triangle = triangle;
    hit_.t = crossing.t;
    crossing_ = crossing;
    span_.last = moved(crossing.t, 1);
  }

  void complete() {
    const TriangleCorners corners = field_.triangle(hit_.triangle);
    hit_.barycentrics = crossing_weights(line_, corners, crossing_);
    hit_.normal = unit_normal(corners);
  }

  const HeightField& field_;
  const Ray& ray_;
  RayLine line_;
  Facing facing_;
  QueryStats& work_;
  Span span_;  ///< hits outside do not count
  RayHit hit_;
  RayCrossing crossing_;
  std::size_t size_ = 0;
  Entered entered_[kMaxEntered];  // a stack
};

}  // namespace
}  // namespace detail

QueryStats cast(const HeightField& field, std::span<const Ray> rays, std::span<RayHit> hits,
                Facing facing) {
  detail::require(hits.size() == rays.size(), "cast: give one hit for each ray");
  detail::require(detail::are_valid(rays), "cast: a ray has a NaN or infinite coordinate");
  QueryStats stats;
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = detail::FieldCast(field.detail(), rays[i], facing, stats).run();
  return stats;
}

QueryStats cast(const HeightField& field, const Ray& ray, RayHit& result, Facing facing) {
  return cast(field, std::span(&ray, 1), std::span(&result, 1), facing);
}

}  // namespace pelt
