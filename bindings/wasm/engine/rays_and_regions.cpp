/// Rays, and regions of space: hits of a pose, and placements of it and of its triangles.

#include <pelt/ray.hpp>
#include <pelt/solid.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"

namespace pelt::wasm {
namespace {

/// Numbers of a hit: triangle, t, the three weights, the normal.
constexpr std::size_t kHitNumbers = 8;

/// `first` is the number of the pose's first triangle in the character.
void push(const RayHit& hit, std::uint32_t first, std::vector<double>& rows) {
  const auto& [u, v, w] = hit.barycentrics;
  const auto& [x, y, z] = hit.normal;
  rows.insert(rows.end(), {static_cast<double>(first + hit.triangle), hit.t, u, v, w, x, y, z});
}

/// The answer is the hits, `kHitNumbers` each.
void answer_hits(std::span<const RayHit> hits, const PoseHandle& handle) {
  static std::vector<double> rows;
  rows.clear();
  rows.reserve(kHitNumbers * hits.size());
  for (const RayHit& hit : hits) push(hit, handle.body.first_triangle, rows);
  answer_arrays(rows);
}

/// Same numbers as in regions.mjs.
enum class Kind : std::uint32_t {
  half_space,
  box,
  oriented_box,
  polyhedron,
  sphere,
  capsule,
  frustum_gl,      ///< a matrix whose depth is -1 to 1
  frustum_webgpu,  ///< or 0 to 1
};

/// Reads the numbers of a region one after the other, in the order of the members of its
/// struct (pelt/math.hpp).
class Reader {
 public:
  explicit Reader(std::span<const float> numbers) : numbers_(numbers) {}

  bool has_more() const { return next_ < numbers_.size(); }
  float number() { return numbers_[next_++]; }
  Vec3 vector() { return Vec3{number(), number(), number()}; }
  HalfSpace half_space() { return HalfSpace{vector(), number()}; }

  Matrix4 matrix() {
    Matrix4 matrix;
    for (float& element : matrix.m) element = number();
    return matrix;
  }

 private:
  std::span<const float> numbers_;
  std::size_t next_ = 0;
};

ConvexPolyhedron read_polyhedron(Reader& reader) {
  std::vector<HalfSpace> faces;
  while (reader.has_more()) faces.push_back(reader.half_space());
  return ConvexPolyhedron(faces);
}

Region read_region(Kind kind, std::span<const float> numbers) {
  Reader reader(numbers);
  switch (kind) {
    case Kind::half_space:
      return reader.half_space();
    case Kind::box:
      return Box{reader.vector(), reader.vector()};
    case Kind::oriented_box:
      return OrientedBox{
          reader.vector(), {reader.vector(), reader.vector(), reader.vector()}, reader.vector()};
    case Kind::polyhedron:
      return read_polyhedron(reader);
    case Kind::sphere:
      return Sphere{reader.vector(), reader.number()};
    case Kind::capsule:
      return Capsule{reader.vector(), reader.vector(), reader.number()};
    case Kind::frustum_gl:
      return make_frustum(reader.matrix(), ClipDepth::minus_one_to_one);
    case Kind::frustum_webgpu:
      break;
  }
  return make_frustum(reader.matrix(), ClipDepth::zero_to_one);
}

}  // namespace

/// JavaScript writes origin, direction, least t and greatest t of a ray.
static_assert(sizeof(Ray) == 8 * sizeof(float));

/// Answers with the first hit.
bool cast(PoseHandle& handle, std::span<const Ray> ray, Facing facing) {
  RayHit hit;
  answer_stats(cast(handle.pose, ray[0], hit, facing));
  answer_hits({&hit, 1}, handle);
  return static_cast<bool>(hit);
}
PELT_EXPORT(cast)

bool cast_any(PoseHandle& handle, std::span<const Ray> ray, Facing facing) {
  bool hit = false;
  answer_stats(cast_any(handle.pose, ray, {&hit, 1}, facing));
  return hit;
}
PELT_EXPORT(cast_any)

QueryStats cast_all(PoseHandle& handle, std::span<const Ray> ray, Facing facing) {
  static std::vector<RayHit> hits;
  hits.clear();
  const QueryStats stats = cast_all(handle.pose, ray[0], scratch(), hits, facing);
  answer_hits(hits, handle);
  return stats;
}
PELT_EXPORT(cast_all)

Placement classify(PoseHandle& handle, Kind kind, std::span<const float> numbers) {
  Placement placement = Placement::outside;
  answer_stats(classify(handle.pose, read_region(kind, numbers), scratch(), placement));
  return placement;
}
PELT_EXPORT(classify)

YesNo intersects_region(PoseHandle& handle, Kind kind, std::span<const float> numbers) {
  return intersects(handle.pose, read_region(kind, numbers), scratch());
}
PELT_EXPORT(intersects_region)

/// Answers with the triangles that touch, and with those inside.
QueryStats find_triangles(PoseHandle& handle, Kind kind, std::span<const float> numbers) {
  static TrianglesInRegion found;
  found.intersecting.clear();
  found.inside.clear();
  const QueryStats stats =
      find_triangles(handle.pose, read_region(kind, numbers), scratch(), found);
  for (std::uint32_t& triangle : found.intersecting) triangle += handle.body.first_triangle;
  for (std::uint32_t& triangle : found.inside) triangle += handle.body.first_triangle;
  answer_arrays(found.intersecting, found.inside);
  return stats;
}
PELT_EXPORT(find_triangles)

}  // namespace pelt::wasm
