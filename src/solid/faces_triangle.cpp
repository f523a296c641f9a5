#include "solid/faces_triangle.hpp"

#include "solid/faces_by_signs.hpp"

namespace pelt::detail {
namespace {

class StillFaces {
 public:
  StillFaces(const TriangleCorners& triangle, std::span<const Face> faces)
      : triangle_(triangle), faces_(faces) {}

  template <typename Number>
  Number side(std::size_t face, std::size_t corner) const {
    const Face& f = faces_[face];
    return dot(Vector<Number>(f.normal),
               Vector<Number>(triangle_[corner]) - Vector<Number>(f.origin)) -
           Number(static_cast<double>(f.offset));
  }

  template <typename Polynomial>
  int sign(const Polynomial& polynomial) const {
    return exact_sign(polynomial);
  }

 private:
  const TriangleCorners& triangle_;
  std::span<const Face> faces_;
};

}  // namespace

TrianglePlace place_triangle(const TriangleCorners& triangle, std::span<const Face> faces) {
  const StillFaces source(triangle, faces);
  return FacesBySigns(source).place(faces.size());
}

}  // namespace pelt::detail
