#pragma once

/// A triangle and a polyhedron, by signs of polynomials. Let s_i(k) be the distance of corner k
/// outside of face i: positive outside, and linear on the triangle. By Farkas's lemma, the triangle
/// and the polyhedron have no common point if and only if some combination sum y_i s_i, y_i >= 0,
/// is positive at all three vertices: a combination of half-spaces that contains the polyhedron and
/// excludes the triangle. The vectors (s_i(0), s_i(1), s_i(2)) and the negative unit vectors then
/// have e = (1, 1, 1) in their cone and, by Caratheodory, so have three linearly independent ones
/// of them. If these are faces alone, there are
///
///   one       face with all vertices outside;
///   two       faces i and j with a ratio r > 0 such that s_i + r s_j > 0 at each vertex. A vertex
///             with s_i < 0 < s_j bounds r from below by -s_i / s_j, one with s_j < 0 < s_i from
///             above. The bounds are compared by 2 x 2 determinants;
///   three     faces, and e = y_i s_i + y_j s_j + y_k s_k is solved by Cramer's rule: no y is
///             negative if no determinant with e in place of a row has the opposite sign of the
///             determinant of the rows.
///
/// With negative unit vectors among the three, fewer faces suffice, which these conditions cover.
/// Faces without a vertex outside contribute nothing positive and are skipped.

#include "base/assert.hpp"
#include "exact/exact_number.hpp"
#include "solid/region_triangle.hpp"

#include <array>
#include <cstddef>

namespace pelt::detail {

/// Faces that exclude a triangle together.
struct Separators {
  std::array<std::size_t, 3> faces{};
  std::size_t count = 0;
};

/// `Source` gives numbers and signs:
///   Number side<Number>(face, corner) const   s_face(corner), times a positive number per face
///   int sign(polynomial) const                of a template `polynomial(const Number&)`
template <typename Source>
class FacesBySigns {
 public:
  explicit FacesBySigns(const Source& source) : source_(source) {}

  /// Precondition: there are at most kMaxFaces faces.
  TrianglePlace place(std::size_t face_count) {
    PELT_ASSERT(face_count <= ConvexPolyhedron::kMaxFaces);
    std::array<bool, 3> is_inside = {true, true, true};
    for (std::size_t i = 0; i < face_count; ++i) {
      const Signs signs = signs_of(i);
      if (signs[0] > 0 && signs[1] > 0 && signs[2] > 0) return separated_by({{i}, 1});
      bool crosses = false;
      for (std::size_t k = 0; k < 3; ++k)
        if (signs[k] > 0) is_inside[k] = false, crosses = true;
      if (crosses) add_crossing(i, signs);
    }
    if (crossing_count_ == 0) return TrianglePlace::inside;
    if (crossing_count_ == 1 || is_inside[0] || is_inside[1] || is_inside[2])
      return TrianglePlace::touching;
    return is_apart_by_two() || is_apart_by_three() ? TrianglePlace::apart
                                                    : TrianglePlace::touching;
  }

  /// If the triangle is apart: faces that exclude it.
  const Separators& separators() const { return separators_; }

  // The polynomials whose signs are used.

  /// s_i(u) s_j(l) - s_i(l) s_j(u)
  template <typename Number>
  Number minor(std::size_t i, std::size_t j, std::size_t u, std::size_t l) const {
    return side<Number>(i, u) * side<Number>(j, l) - side<Number>(i, l) * side<Number>(j, u);
  }

  template <typename Number>
  Number determinant(std::size_t i, std::size_t j, std::size_t k) const {
    return dot(sides<Number>(i), cross(sides<Number>(j), sides<Number>(k)));
  }

  /// The determinant of the rows e, s_j, s_k.
  template <typename Number>
  Number determinant_with_ones(std::size_t j, std::size_t k) const {
    const Vector<Number> minors = cross(sides<Number>(j), sides<Number>(k));
    return minors.x + minors.y + minors.z;
  }

  template <typename Number>
  Number side(std::size_t face, std::size_t corner) const {
    return source_.template side<Number>(face, corner);
  }

 private:
  /// Signs of one face at the three corners.
  using Signs = std::array<int, 3>;

  /// A face with corners on both sides.
  struct Crossing {
    std::size_t face;
    Signs signs;
  };

  void add_crossing(std::size_t face, const Signs& signs) {
    crossings_[crossing_count_++] = {face, signs};
  }

  TrianglePlace separated_by(const Separators& separators) {
    separators_ = separators;
    return TrianglePlace::apart;
  }

  /// A face's values at all corners.
  template <typename Number>
  Vector<Number> sides(std::size_t face) const {
    return {side<Number>(face, 0), side<Number>(face, 1), side<Number>(face, 2)};
  }

  Signs signs_of(std::size_t face) const {
    Signs signs;
    for (std::size_t k = 0; k < 3; ++k)
      signs[k] =
          source_.sign([&]<typename Number>(const Number&) { return side<Number>(face, k); });
    return signs;
  }

  int minor_sign(std::size_t i, std::size_t j, std::size_t u, std::size_t l) const {
    return source_.sign([&]<typename Number>(const Number&) { return minor<Number>(i, j, u, l); });
  }

  bool are_apart(const Crossing& i, const Crossing& j) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (i.signs[k] <= 0 && j.signs[k] <= 0) return false;
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t u = 0; u < 3; ++u)
        if (i.signs[l] < 0 && j.signs[u] < 0 && minor_sign(i.face, j.face, u, l) <= 0) return false;
    return true;
  }

  bool is_apart_by_two() {
    for (std::size_t i = 0; i < crossing_count_; ++i)
      for (std::size_t j = i + 1; j < crossing_count_; ++j)
        if (are_apart(crossings_[i], crossings_[j])) {
          separators_ = {{crossings_[i].face, crossings_[j].face}, 2};
          return true;
        }
    return false;
  }

  int ones_sign(std::size_t j, std::size_t k) const {
    return source_.sign(
        [&]<typename Number>(const Number&) { return determinant_with_ones<Number>(j, k); });
  }

  bool are_apart(std::size_t i, std::size_t j, std::size_t k) const {
    const int rows =
        source_.sign([&]<typename Number>(const Number&) { return determinant<Number>(i, j, k); });
    return rows != 0 && rows * ones_sign(j, k) >= 0 && rows * ones_sign(k, i) >= 0 &&
           rows * ones_sign(i, j) >= 0;
  }

  bool is_apart_by_three() {
    for (std::size_t i = 0; i < crossing_count_; ++i)
      for (std::size_t j = i + 1; j < crossing_count_; ++j)
        for (std::size_t k = j + 1; k < crossing_count_; ++k)
          if (are_apart(crossings_[i].face, crossings_[j].face, crossings_[k].face)) {
            separators_ = {{crossings_[i].face, crossings_[j].face, crossings_[k].face}, 3};
            return true;
          }
    return false;
  }

  const Source& source_;
  std::array<Crossing, ConvexPolyhedron::kMaxFaces> crossings_;
  std::size_t crossing_count_ = 0;
  Separators separators_;
};

}  // namespace pelt::detail
