#pragma once

/// Terrain: a grid of heights as the second operand of `collide` and `distance`, and for rays.

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/distance.hpp>
#include <pelt/export.hpp>
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
/// Columns follow each other along x, rows along z.
///
/// The vertex in column c of row r is (origin.x + c * column_spacing, origin.y + heights[r *
/// columns + c], origin.z + r * row_spacing). Each coordinate is computed in double and rounded to
/// float once. A vertex whose height is NaN makes a hole: queries ignore the triangles that use the
/// vertex, but these triangles keep their numbers.
struct HeightGrid {
  std::span<const float> heights;  ///< [rows][columns]
  std::uint32_t columns = 0, rows = 0;
  Vec3 origin;
  float column_spacing = 1, row_spacing = 1;
};

/// A validated height field, prepared for queries. Immutable, cheap to copy (copies share), safe to
/// use from any number of threads.
///
/// The cell in column c of row r has four vertices. Its diagonal divides it into the triangles
/// n = 2 (r (columns - 1) + c) and n + 1. The fronts of all triangles face up. Seen from above:
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

  /// Vertices of a triangle. y is NaN for a vertex with a height of NaN.
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
/// Returns an error if there are fewer than two columns or rows, more than 2^32 - 2 triangles, or
/// not exactly rows x columns heights; if a spacing is not positive, a height is infinite, or a
/// coordinate exceeds 2^60; or if neighbouring columns or rows round to the same coordinate.
PELT_API Result<HeightField> build_height_field(const HeightGrid& grid);

/// Appends every pair of intersecting triangles of the posed skin and the field, in ascending
/// order. `Contact::triangle_b` is a triangle of the field.
///
/// Exact like `collide` of two poses, with the same predicate. A field is a surface: touching
/// counts, and a body wholly below it touches nothing.
///
/// Cost: compares each box with the range of heights that the field has at the box's x and z. Opens
/// a node only if its box overlaps this range. A hierarchy gives the range in constant time,
/// however large the field is. Triangles of the field are generated only where they are needed.
/// Allocates like `collide` of two poses.
PELT_API QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                            std::vector<Contact>& contacts, const CollideOptions& options = {});

/// Returns whether any triangles intersect. Like `collide`, but stops at the first contact.
PELT_API YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch);

/// Writes the least distance of any triangle of the posed skin from any triangle of the field, like
/// `distance` of two poses. `Distance::b` is on the field. Points below the ground have a positive
/// distance, like points above it. If every triangle of the field is ignored because of a hole, the
/// distance is infinite. Cost and allocation are those of `distance` of two poses.
PELT_API QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch,
                             Distance& result, const DistanceOptions& options = {});

/// Writes the first hit of each ray on the field, exact like `cast` on a pose. `RayHit::location`
/// is meaningless for a hit on a field.
///
/// Precondition: `hits` has one element per ray. Otherwise the program aborts, in every build.
///
/// Cost: visits square blocks of cells in the order in which a ray enters them. In each block,
/// tests the cells that the ray passes. Allocates nothing.
PELT_API QueryStats cast(const HeightField& field, std::span<const Ray> rays,
                         std::span<RayHit> hits, const CastOptions& options = {});

/// Like `cast` of several rays, for one ray.
PELT_API QueryStats cast(const HeightField& field, const Ray& ray, RayHit& result,
                         const CastOptions& options = {});

}  // namespace pelt
