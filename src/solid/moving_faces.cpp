/// Reduction to finitely many times. The polynomials of a set of faces, of the kinds in
/// faces_by_signs.hpp, decide whether these faces exclude the triangle, so the answer changes only
/// at their roots. The triangle is apart from the polyhedron on an open set of times. If it is
/// apart at a time, it is therefore apart just after this time, too, and some faces exclude it
/// there. The next time to test is the first later root of the polynomials of these faces. There
/// are finitely many faces and roots, so the search ends.
///
/// Bits. The elements of a normal are multiples of a power of two and have at most 277 bits,
/// because floats are multiples of 2^-149 below 2^128. Differences of a corner and an origin have
/// at most 278 bits, their products with normals are below 2^555, and a sum of three less an offset
/// is below 2^557. Such a distance moves from s to s + d with |d| < 2^558. A determinant of three
/// rows is a sum of six products with coefficients below 12 * 2^(3 * 557), thus below 2^1678.

#include "exact/scaled_float.hpp"
#include "solid/faces_by_signs.hpp"
#include "solid/moving_numbers.hpp"
#include "solid/region_triangle.hpp"

#include <limits>
#include <utility>

namespace pelt::detail {
namespace {

using SexticRoot = RootOf<Sextic>;

std::array<float, 3> elements(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The distances of a moving triangle's corners from faces, as functions of time.
class MovingSides {
 public:
  MovingSides(const MovingTriangle& triangle, std::span<const Face> faces)
      : triangle_(triangle), faces_(faces) {
    for (std::size_t face = 0; face < faces.size(); ++face)
      for (std::size_t corner = 0; corner < 3; ++corner)
        rounded_[face][corner] = {rounded_side(faces[face], triangle.from[corner]),
                                  rounded_side(faces[face], triangle.to[corner])};
  }

  Rounded side(std::size_t face, std::size_t corner, const Rounded& time) const {
    const auto& [from, to] = rounded_[face][corner];
    return at_time(from, to, time);
  }

  /// In a unit of the face.
  Sextic side(std::size_t face, std::size_t corner) const {
    Sextic result;
    result.coefficients[0] = side_of(faces_[face], triangle_.from[corner]);
    result.coefficients[1] = side_of(faces_[face], triangle_.to[corner]);
    result.coefficients[1] -= result.coefficients[0];
    return result;
  }

 private:
  using Integer = Sextic::Coefficient;

  static Rounded rounded_side(const Face& face, const Vec3& p) {
    const auto vector = [](const Vec3& v) { return Vector<Rounded>(v); };
    return dot(vector(face.normal), vector(p) - vector(face.origin)) - Rounded(double{face.offset});
  }

  /// The exponent of a power of two that divides all of the values.
  static int unit_of(std::initializer_list<Vec3> vectors) {
    int unit = 128;
    for (const Vec3& v : vectors)
      for (const float value : elements(v))
        if (value != 0) unit = std::min(unit, OddTimesPower(value).exponent);
    return unit;
  }

  Integer side_of(const Face& face, const Vec3& point) const {
    const auto& [a, b, c] = triangle_.from;
    const auto& [d, e, f] = triangle_.to;
    const int of_points = unit_of({a, b, c, d, e, f, face.origin});
    const int of_normal = unit_of({face.normal});
    int unit = of_points + of_normal;
    if (face.offset != 0) unit = std::min(unit, OddTimesPower(face.offset).exponent);

    Integer sum, product;
    const auto normal = elements(face.normal), origin = elements(face.origin);
    const auto at = elements(point);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Integer difference = scaled<Sextic::kBits>(at[axis], of_points);
      difference -= scaled<Sextic::kBits>(origin[axis], of_points);
      product.assign_product(difference, scaled<Sextic::kBits>(normal[axis], of_normal));
      sum += product;
    }
    sum <<= static_cast<unsigned>(of_points + of_normal - unit);
    return sum -= scaled<Sextic::kBits>(face.offset, unit);
  }

  const MovingTriangle& triangle_;
  std::span<const Face> faces_;
  std::array<std::array<std::array<Rounded, 2>, 3>, ConvexPolyhedron::kMaxFaces> rounded_;
};

/// `Signs`: RegionInstant or RegionPiece.
template <typename Signs>
class FacesSource {
 public:
  FacesSource(const MovingSides& sides, const Signs& signs) : sides_(sides), signs_(signs) {}

  template <typename Number>
  Number side(std::size_t face, std::size_t corner) const {
    if constexpr (std::is_same_v<Number, Rounded>) {
      return sides_.side(face, corner, signs_.enclosure());
    } else {
      return sides_.side(face, corner);
    }
  }

  template <typename AnyPolynomial>
  int sign(const AnyPolynomial& polynomial) const {
    return signs_.sign(polynomial);
  }

 private:
  const MovingSides& sides_;
  const Signs& signs_;
};

/// Calls visit(polynomial) for the polynomials whose signs decide whether some faces exclude the
/// triangle.
template <typename Visit>
void for_each_polynomial(const Separators& separators, const MovingSides& sides,
                         const Visit& visit) {
  const RegionInstant start(nullptr, Moment::at);
  const FacesSource source(sides, start);
  const FacesBySigns polynomials(source);
  const auto [i, j, k] = separators.faces;
  if (separators.count == 3) {
    visit(polynomials.template determinant<Sextic>(i, j, k));
    visit(polynomials.template determinant_with_ones<Sextic>(i, j));
    visit(polynomials.template determinant_with_ones<Sextic>(j, k));
    visit(polynomials.template determinant_with_ones<Sextic>(k, i));
    return;
  }
  for (std::size_t face = 0; face < separators.count; ++face)
    for (std::size_t corner = 0; corner < 3; ++corner)
      visit(sides.side(separators.faces[face], corner));
  if (separators.count == 1) return;
  for (std::size_t corner = 0; corner < 3; ++corner)
    visit(polynomials.template minor<Sextic>(i, j, corner, (corner + 1) % 3));
}

class FirstTouchOfFaces {
 public:
  FirstTouchOfFaces(const MovingTriangle& triangle, std::span<const Face> faces)
      : triangle_(triangle), face_count_(faces.size()), faces_(faces), sides_(triangle, faces) {}

  std::optional<FirstTouch> run() {
    if (place_triangle(triangle_.from, faces_) != TrianglePlace::apart) return FirstTouch{0, true};
    while (advance())
      if (is_touching()) return FirstTouch{time_->rounded_down(), false};
    if (place_triangle(triangle_.to, faces_) != TrianglePlace::apart) return FirstTouch{1, false};
    return std::nullopt;
  }

 private:
  const SexticRoot* root() const { return time_ ? &*time_ : nullptr; }

  bool is_touching() const {
    const RegionInstant instant(root(), Moment::at);
    const FacesSource source(sides_, instant);
    return FacesBySigns(source).place(face_count_) != TrianglePlace::apart;
  }

  Separators separators_after() const {
    const RegionInstant instant(root(), Moment::after);
    const FacesSource source(sides_, instant);
    FacesBySigns test(source);
    [[maybe_unused]] const TrianglePlace place = test.place(face_count_);
    PELT_ASSERT(place == TrianglePlace::apart);
    return test.separators();
  }

  /// Goes to the next time to test. Returns false if there is none before time 1.
  bool advance() {
    std::optional<SexticRoot> next;
    for_each_polynomial(separators_after(), sides_, [&](const Sextic& p) {
      RootsOf<Sextic> found;
      find_critical_times(p, found);
      for (std::size_t i = 0; i < found.count; ++i) {
        const SexticRoot& time = found.entries[i].time;
        if (time_ && time.compare(*time_) <= 0) continue;
        if (!next || time.compare(*next) < 0) next = time;
      }
    });
    if (next) time_ = next;
    return next.has_value();
  }

  const MovingTriangle& triangle_;
  std::size_t face_count_;
  std::span<const Face> faces_;
  MovingSides sides_;
  std::optional<SexticRoot> time_;  // at the start: none
};

/// Weights of faces that exclude the triangle together. The weighted sum of the corners' distances
/// outside of the faces is positive at all corners.
struct WeightedFaces {
  Separators faces;
  std::array<double, 3> weights = {1, 0, 0};
};

/// Distances of the three corners outside of a face.
Vec3d rounded_sides(const MovingSides& sides, std::size_t face, double time) {
  const auto side = [&](std::size_t corner) {
    return sides.side(face, corner, Rounded(time)).value();
  };
  return {side(0), side(1), side(2)};
}

/// The middle of the possible ratios of the weights of two faces (faces_by_signs.hpp), or twice the
/// least one.
double ratio_of(const Vec3d& i, const Vec3d& j) {
  double least = 0, greatest = std::numeric_limits<double>::infinity();
  for (const auto& [of_i, of_j] : {std::pair(i.x, j.x), std::pair(i.y, j.y), std::pair(i.z, j.z)}) {
    if (of_i < 0) least = std::max(least, -of_i / of_j);
    if (of_j < 0) greatest = std::min(greatest, -of_i / of_j);
  }
  return std::isfinite(greatest) ? least + (greatest - least) / 2 : 2 * least;
}

/// Rounded: the sum must be tested.
WeightedFaces weighted(const Separators& faces, const MovingSides& sides, double time) {
  WeightedFaces result{faces};
  if (faces.count == 1) return result;
  const Vec3d i = rounded_sides(sides, faces.faces[0], time);
  const Vec3d j = rounded_sides(sides, faces.faces[1], time);
  if (faces.count == 2) {
    result.weights[1] = ratio_of(i, j);
    return result;
  }
  const Vec3d k = rounded_sides(sides, faces.faces[2], time);
  const auto with_ones = [](const Vec3d& p, const Vec3d& q) {
    const Vec3d minors = cross(p, q);
    return std::abs(minors.x + minors.y + minors.z);
  };
  result.weights = {with_ones(j, k), with_ones(k, i), with_ones(i, j)};
  return result;
}

class CertainFaces {
 public:
  CertainFaces(const MovingTriangle& triangle, std::span<const Face> faces)
      : face_count_(faces.size()), sides_(triangle, faces) {}

  /// Faces that exclude the triangle a little later may exclude it longer than those that do so
  /// now.
  double apart_until(double low) const {
    constexpr double kLittle = 0x1p-20;
    return std::max(excluded_until(low, std::min(low + kLittle, 1.0)), excluded_until(low, low));
  }

  bool touches(double time) const {
    const RegionPiece instant(time, time);
    const FacesSource source(sides_, instant);
    const TrianglePlace place = FacesBySigns(source).place(face_count_);
    return place != TrianglePlace::apart && instant.take_certain();
  }

 private:
  /// Up to a time at which faces that exclude the triangle at a time still exclude it. While the
  /// weights stay the same, the weighted sums are linear functions of time.
  double excluded_until(double low, double time) const {
    const RegionPiece instant(time, time);
    const FacesSource source(sides_, instant);
    FacesBySigns test(source);
    if (test.place(face_count_) != TrianglePlace::apart) return low;
    const WeightedFaces faces = weighted(test.separators(), sides_, time);
    for (const double margin : kRootMargins) {
      double until = 1;
      for (std::size_t corner = 0; corner < 3; ++corner)
        until = std::min(until, just_before_root(low, sum(faces, corner, low).value(),
                                                 sum(faces, corner, 1).value(), margin));
      if (until > low && exclude(faces, low) && exclude(faces, until)) return until;
    }
    return low;
  }

  Rounded sum(const WeightedFaces& faces, std::size_t corner, double time) const {
    Rounded sum;
    for (std::size_t i = 0; i < faces.faces.count; ++i)
      sum = sum +
            Rounded(faces.weights[i]) * sides_.side(faces.faces.faces[i], corner, Rounded(time));
    return sum;
  }

  bool exclude(const WeightedFaces& faces, double time) const {
    for (std::size_t corner = 0; corner < 3; ++corner)
      if (sum(faces, corner, time).sign() != 1) return false;
    return true;
  }

  std::size_t face_count_;
  MovingSides sides_;
};

}  // namespace

std::optional<FirstTouch> first_touch(const MovingTriangle& triangle, std::span<const Face> faces) {
  return FirstTouchOfFaces(triangle, faces).run();
}

CertainAnswer certainly_touches(const MovingTriangle& triangle, std::span<const Face> faces) {
  return certainly_touches(CertainFaces(triangle, faces));
}

bool find_certain_first_touch(const MovingTriangle& triangle, std::span<const Face> faces,
                              std::optional<FirstTouch>& touch) {
  return find_certain_first_touch(CertainFaces(triangle, faces), touch);
}

}  // namespace pelt::detail
