/// Regions of space: placements of poses and of their triangles.

#include <pelt/region.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

namespace pelt::wasm {
namespace {

/// Numbered as in regions.mjs.
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

/// Reads these numbers one after the other.
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
  static std::vector<HalfSpace> faces;
  faces.clear();
  while (reader.has_more()) faces.push_back(reader.half_space());
  return {faces};
}

ConvexPolyhedron read_frustum(Reader& reader, ClipDepth depth) {
  static Frustum frustum;
  frustum = make_frustum(reader.matrix(), depth);
  return frustum;
}

/// What the numbers stand for. It may borrow, until the next one is read.
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
      return read_frustum(reader, ClipDepth::minus_one_to_one);
    case Kind::frustum_webgpu:
      break;
  }
  return read_frustum(reader, ClipDepth::zero_to_one);
}

}  // namespace

PELT_EXPORT float* pelt_region(std::uint32_t count) {
  region_numbers().resize(count);
  return region_numbers().data();
}

PELT_EXPORT std::uint32_t pelt_classify(PoseHandle* handle, Kind kind) {
  const Classified found = classify(handle->pose, read_region(kind), scratch());
  answer_stats(found.stats);
  return static_cast<std::uint32_t>(found.placement);
}

PELT_EXPORT std::uint32_t pelt_intersects_region(PoseHandle* handle, Kind kind) {
  return intersects(handle->pose, read_region(kind), scratch()) ? 1 : 0;
}

/// The answer is the triangles that touch; returns where those inside lie, whose number is the
/// answer's number 6.
PELT_EXPORT const std::uint32_t* pelt_find_triangles(PoseHandle* handle, Kind kind) {
  static TrianglesInRegion found;
  answer_stats(find_triangles(handle->pose, read_region(kind), scratch(), found));
  for (std::uint32_t& triangle : found.touching) triangle += handle->body.first_triangle;
  for (std::uint32_t& triangle : found.inside) triangle += handle->body.first_triangle;
  answer().numbers[6] = static_cast<double>(found.inside.size());
  answer_data<std::uint32_t>(found.touching);
  return found.inside.data();
}

}  // namespace pelt::wasm
