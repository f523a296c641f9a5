#pragma once

/// Terrain that a character meets: a grid of heights as the second operand of `collide` and
/// `distance`, and under rays.

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

/// A borrowed view of a grid of heights, in the frame of the joint palette, with y up as in glTF:
/// columns follow each other along x, rows along z.
///
/// The vertex in column c of row r is (origin.x + c * column_spacing, origin.y + heights[r *
/// columns + c], origin.z + r * row_spacing), each coordinate computed in double and rounded to
/// float once. A height that is NaN is a hole: triangles with such a corner do not exist.
struct HeightGrid {
  std::span<const float> heights;  ///< [rows][columns]
  std::uint32_t columns = 0, rows = 0;
  Vec3 origin;
  float column_spacing = 1, row_spacing = 1;
};

/// A height field, checked and prepared for queries. Immutable, cheap to copy (copies share), safe
/// to use from any number of threads.
///
/// Each cell between four vertices is two triangles that share the diagonal from its lowest column
/// and row to its highest. The cell in column c of row r has the numbers 2 (r (columns - 1) + c),
/// on the side of the next row, and that plus one, on the side of the next column. Their fronts are
/// above.
class PELT_API HeightField {
 public:
  std::uint32_t columns() const;
  std::uint32_t rows() const;

  /// Those of holes counted.
  std::uint32_t triangle_count() const;

  /// The corners of a triangle, some with a y that is NaN where there is a hole. Precondition:
  /// `triangle` is less than `triangle_count()`.
  std::array<Vec3, 3> triangle(std::uint32_t triangle) const;

  /// For Pelt's own files.
  explicit HeightField(std::shared_ptr<const detail::HeightField> field);
  const detail::HeightField& detail() const { return *field_; }

 private:
  std::shared_ptr<const detail::HeightField> field_;
};

/// Checks a grid and prepares it for queries, or says what breaks which rule: fewer than two
/// columns or rows, more than 2^32 - 2 triangles, another number of heights, a spacing that is not
/// positive, a height that is infinite, a coordinate beyond 2^60, columns or rows so close together
/// and so far from the origin of the frame that floats cannot tell them apart.
///
/// O(rows x columns); copies the heights, and keeps 5 bytes a vertex in all.
PELT_API Result<HeightField> build_height_field(const HeightGrid& grid);

/// Appends every pair of a triangle of the posed skin and one of the field that intersect, in
/// ascending order; `Contact::triangle_b` is the field's.
///
/// Exact as `collide` of two poses, by the same predicate: a field is a surface, and touching
/// counts. What is wholly below it touches nothing. Nodes are opened where their boxes come between
/// the least and the greatest height of the field below them, which a hierarchy of these tells in
/// constant time, however large the field is; the field's triangles are made of the heights where
/// they are asked for.
PELT_API QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                            std::vector<Contact>& contacts, const CollideOptions& options = {});

/// Whether any triangles intersect; as `collide`, stopping at the first contact.
PELT_API YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch);

/// The least distance of any triangle of the posed skin from any of the field, as `distance` of two
/// poses; `Distance::b` is on the field. What is below the ground is as far from it as what is
/// above. Infinite, too, if the field has nothing but holes.
PELT_API QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch,
                             Distance& result, const DistanceOptions& options = {});

/// Writes what each ray hits first of the field, exactly as `cast` at a pose; `RayHit::location`
/// has no meaning here. Precondition: `hits` has one element for each ray. Blocks of the field that
/// a ray enters are looked at in their order, of cells only those below or above it. Allocates
/// nothing.
PELT_API QueryStats cast(const HeightField& field, std::span<const Ray> rays,
                         std::span<RayHit> hits, const CastOptions& options = {});

/// The same for one ray.
PELT_API QueryStats cast(const HeightField& field, const Ray& ray, RayHit& result,
                         const CastOptions& options = {});

}  // namespace pelt
