#pragma once

/// Terrain: a grid of heights, for `collide` of poses and of motions, `distance` and rays.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/distance.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/result.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct HeightField;
}

/// A borrowed view of a grid of heights in the frame of the joint palette, with y up as in glTF.
/// The vertex in column c of row r is
///
///     x = origin.x + c * column_spacing
///     y = origin.y + heights[r * columns + c]
///     z = origin.z + r * row_spacing
///
/// Each coordinate is computed in double and rounded to float once. A vertex whose height is NaN
/// makes a hole: queries ignore all triangles with this vertex. Holes do not change the numbers of
/// the other triangles.
struct HeightGrid {
  std::span<const float> heights;  ///< [rows][columns]
  std::uint32_t columns = 0, rows = 0;
  Vec3 origin;
  float column_spacing = 1, row_spacing = 1;
};

/// A validated height field, prepared for queries. Immutable, cheap to copy (copies share the
/// data), safe to use from any number of threads.
///
/// The cell between columns c and c + 1 and between rows r and r + 1 consists of two triangles,
/// with the numbers n = 2 (r (columns - 1) + c) and n + 1. The fronts of all triangles face up.
/// Seen from above:
///
///             c       c + 1
///     r       *---------*---> x
///             | \ n + 1 |
///             |  n  \   |
///     r + 1   *---------*
///             z
class PELT_API HeightField {
 public:
  std::uint32_t columns() const;
  std::uint32_t rows() const;

  /// Number of triangles, including those that queries ignore because of a hole.
  std::uint32_t triangle_count() const;

  /// Returns the vertices of a triangle. If the height of a vertex is NaN, its y is NaN.
  ///
  /// Precondition: triangle < triangle_count().
  std::array<Vec3, 3> triangle(std::uint32_t triangle) const;

  /// For internal use.
  explicit HeightField(std::shared_ptr<const detail::HeightField> field);
  const detail::HeightField& detail() const { return *field_; }

 private:
  std::shared_ptr<const detail::HeightField> field_;
};

/// Validates a grid, copies its heights and prepares it for queries.
///
/// Cost: O(rows x columns). The field takes 5 bytes per vertex.
///
/// Returns an error if
/// - there are fewer than two columns or rows, or more than 2^32 - 2 triangles;
/// - `heights` does not have exactly rows x columns elements;
/// - a spacing is not positive and finite;
/// - a height is infinite, or the absolute value of a coordinate is more than 2^60;
/// - two neighbouring columns, or two neighbouring rows, are rounded to the same coordinate.
PELT_API Result<HeightField> build_height_field(const HeightGrid& grid);

/// Appends every pair of intersecting triangles of the posed skin and the field, in ascending
/// order. `Contact::triangle_b` is a triangle of the field.
///
/// Exact like `collide` of two poses: triangles that only touch intersect. A field is a surface and
/// not a solid: a body wholly below the field has no contacts.
///
/// Cost: for each box, the query looks up the least and the greatest height of the field within the
/// box's range of x and z. A node is opened only if its box overlaps this range of heights. A
/// look-up takes constant time for fields of any size. Triangles of the field are generated only
/// where they are needed. Allocates like `collide` of two poses.
PELT_API QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                            std::vector<Contact>& contacts, const Limits& limits = {});

/// Returns whether any triangle of the posed skin intersects the field. Like `collide`, but stops
/// at the first contact.
PELT_API YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch);

/// Appends every pair of triangles of the moving skin and the field that intersect at any time from
/// 0 to 1, in ascending order. The field stands still. `Contact::triangle_b` is a triangle of the
/// field.
///
/// Precondition, exactness and allocation: as `collide` of two motions.
///
/// Cost: as `collide` of a pose and a field, with boxes around both ends of the motion, and with
/// nodes opened at both ends.
PELT_API MovingStats collide(const Motion& motion, const HeightField& field, Scratch& scratch,
                             std::vector<MovingContact>& contacts,
                             const MovingOptions& options = {});

/// Returns whether any triangle of the moving skin intersects the field at any time. Like
/// `collide`, but stops at the first contact that it finds.
PELT_API YesNo intersects(const Motion& motion, const HeightField& field, Scratch& scratch);

/// Writes the least distance between a triangle of the posed skin and a triangle of the field.
/// `Distance::b` is on the field. A skin below the field has a positive distance, like a skin above
/// the field. If all triangles of the field are ignored because of holes, the distance is infinite.
/// Exactness, error, cost and allocation are those of `distance` of two poses.
PELT_API QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch,
                             Distance& result, const DistanceOptions& options = {});

/// Writes the first hit of each ray on the field. Exact like `cast` on a pose. `RayHit::triangle`
/// is a triangle of the field. `RayHit::location` is meaningless.
///
/// Precondition: `hits` has one element per ray. Otherwise the program aborts, in every build.
///
/// Cost: visits square blocks of cells in the order in which the ray enters the blocks. In each
/// block, tests the cells that the ray crosses. Allocates nothing.
PELT_API QueryStats cast(const HeightField& field, std::span<const Ray> rays,
                         std::span<RayHit> hits, Facing facing = Facing::both);

/// Like `cast` of several rays, for one ray.
PELT_API QueryStats cast(const HeightField& field, const Ray& ray, RayHit& result,
                         Facing facing = Facing::both);

}  // namespace pelt
