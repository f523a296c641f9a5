/// Regions of space: placements of poses and of their triangles.

#include <pelt/solid.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

namespace pelt::wasm {
namespace {

/// Same numbers as in solids.mjs.
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

/// Memory where JavaScript writes the numbers of a region, in the order of the structs of
/// shapes.hpp.
std::vector<float>& region_numbers() {
  static std::vector<float> numbers;
  return numbers;
}

/// Reads the numbers of a region one after the other.
class Reader {
 public:
  bool has_more() const { return next_ < region_numbers().size(); }
  float number() { return region_numbers()[next_++]; }
  Vec3 vector() { return Vec3{number(), number(), number()}; }
  HalfSpace half_space() { return HalfSpace{vector(), number()}; }

  Matrix4 matrix() {
    Matrix4 matrix;
    for (float& element : matrix.m) element = number();
    return matrix;
  }

 private:
  std::size_t next_ = 0;
};

ConvexPolyhedron read_polyhedron(Reader& reader) {
  std::vector<HalfSpace> faces;
  while (reader.has_more()) faces.push_back(reader.half_space());
  return ConvexPolyhedron(faces);
}

/// Returns the region that the numbers describe.
Region read_region(Kind kind) {
  Reader reader;
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

PELT_EXPORT float* pelt_region(std::uint32_t count) {
  region_numbers().resize(count);
  return region_numbers().data();
}

PELT_EXPORT std::uint32_t pelt_classify(PoseHandle* handle, Kind kind) {
  Placement placement = Placement::outside;
  answer_stats(classify(handle->pose, read_region(kind), scratch(), placement));
  return static_cast<std::uint32_t>(placement);
}

PELT_EXPORT std::uint32_t pelt_intersects_region(PoseHandle* handle, Kind kind) {
  return answer_yes_no(intersects(handle->pose, read_region(kind), scratch()));
}

/// The answer is the triangles that touch. Returns the address of the triangles inside; their
/// number is the answer's inside_count.
PELT_EXPORT const std::uint32_t* pelt_find_triangles(PoseHandle* handle, Kind kind) {
  static TrianglesInRegion found;
  found.intersecting.clear();
  found.inside.clear();
  answer_stats(find_triangles(handle->pose, read_region(kind), scratch(), found));
  for (std::uint32_t& triangle : found.intersecting) triangle += handle->body.first_triangle;
  for (std::uint32_t& triangle : found.inside) triangle += handle->body.first_triangle;
  answer().inside_count = static_cast<double>(found.inside.size());
  answer_data<std::uint32_t>(found.intersecting);
  return found.inside.data();
}

}  // namespace pelt::wasm
