#pragma once

/// Two moving triangles at one instant, for exact tests: the signs of their polynomials,
/// their corners as points for the templates of the triangle pair test (pair_by_signs.hpp), the
/// instants at which they may first meet (moving_pair.cpp explains why), and their features then.

#include <pelt/motion.hpp>

#include "geometry/pair_by_signs.hpp"
#include "motion/moving_polynomials.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::detail {

/// At a time, or just after it: until the next time at which a sign changes.
enum class Moment : std::uint8_t { at, after };

/// The signs of the polynomials of two moving triangles at one time, or just after it. A sign is
/// computed when it is first needed.
class InstantSigns {
 public:
  InstantSigns(MovingPolynomials& polynomials, const Dyadic& time, Moment moment = Moment::at)
      : polynomials_(polynomials), dyadic_(&time), moment_(moment) {}

  /// Just after the root of a polynomial.
  InstantSigns(MovingPolynomials& polynomials, const CriticalTime& time)
      : polynomials_(polynomials), root_(&time), moment_(Moment::after) {}

  /// `zero` is the number of a polynomial with a root at this time, or kCount.
  InstantSigns(MovingPolynomials& polynomials, const CriticalTime& time, std::size_t zero)
      : polynomials_(polynomials), root_(&time) {
    if (zero < MovingPolynomials::kCount) signs_[zero] = 0;
  }

  int of(const MovingPolynomials::Signed& polynomial) {
    if (polynomial.sign == 0) return 0;
    std::int8_t& sign = signs_[polynomial.number];
    if (sign == kUnknown) sign = static_cast<std::int8_t>(compute(polynomial.number));
    return polynomial.sign * sign;
  }

 private:
  static constexpr std::int8_t kUnknown = 2;

  int compute(std::size_t number) {
    const Cubic& p = polynomials_[number];
    if (moment_ == Moment::at) return sign_of(p);
    return sign_just_after(p, [this](const Cubic& slope) { return sign_of(slope); });
  }

  int sign_of(const Cubic& p) const {
    return root_ != nullptr ? root_->sign_of(p) : sign_at(p, *dyadic_);
  }

  static std::array<std::int8_t, MovingPolynomials::kCount> all_unknown() {
    std::array<std::int8_t, MovingPolynomials::kCount> signs;
    signs.fill(kUnknown);
    return signs;
  }

  MovingPolynomials& polynomials_;
  const CriticalTime* root_ = nullptr;
  const Dyadic* dyadic_ = nullptr;
  Moment moment_ = Moment::at;
  std::array<std::int8_t, MovingPolynomials::kCount> signs_ = all_unknown();
};

/// A corner of two moving triangles, at one time.
struct InstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0;
};

struct FlatInstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0, axis = 0;
};

using InstantTriangle = std::array<InstantCorner, 3>;

/// Returns -1, 0 or 1 if the coordinate of p is less than, equal to or greater than that of q.
inline int compare(const InstantCorner& p, const InstantCorner& q, std::size_t axis) {
  return p.signs->of(MovingPolynomials::compare(axis, q.corner, p.corner));
}

inline bool all_before(const InstantTriangle& a, const InstantTriangle& b, std::size_t axis) {
  return std::all_of(a.begin(), a.end(), [&](const InstantCorner& p) {
    return std::all_of(b.begin(), b.end(),
                       [&](const InstantCorner& q) { return compare(p, q, axis) < 0; });
  });
}

inline bool disjoint_boxes(const InstantTriangle& a, const InstantTriangle& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (all_before(a, b, axis) || all_before(b, a, axis)) return true;
  return false;
}

inline int orient3d(const InstantCorner& p, const InstantCorner& q, const InstantCorner& r,
                    const InstantCorner& s) {
  return p.signs->of(MovingPolynomials::orient3d({p.corner, q.corner, r.corner, s.corner}));
}

inline PlaneSides sides_of(const InstantTriangle& corners, const InstantTriangle& plane) {
  const auto side = [&](const InstantCorner& p) {
    return orient3d(plane[0], plane[1], plane[2], p);
  };
  return {side(corners[0]), side(corners[1]), side(corners[2])};
}

inline FlatInstantCorner without(const InstantCorner& p, int axis) {
  return {p.signs, p.corner, static_cast<std::size_t>(axis)};
}

inline int orient2d(const FlatInstantCorner& p, const FlatInstantCorner& q,
                    const FlatInstantCorner& r) {
  return p.signs->of(MovingPolynomials::orient2d(p.axis, {p.corner, q.corner, r.corner}));
}

inline bool lexicographically_less(const InstantCorner& p, const InstantCorner& q) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const int order = compare(p, q, axis)) return order < 0;
  return false;
}

inline bool flat_triangles_intersect(const InstantTriangle& a, const InstantTriangle& b) {
  return flat_corners_intersect(a, b);
}

inline bool segment_meets_triangle(const InstantTriangle& collapsed,
                                   const InstantTriangle& triangle) {
  return segment_meets_corners(collapsed, triangle);
}

/// Numbers of three corners of six: first those of a, then those of b. Corners may be repeated.
using CornerNumbers = std::array<std::size_t, 3>;

/// Whether the hulls of two triples of corners intersect.
inline bool hulls_meet(InstantSigns& signs, const CornerNumbers& a, const CornerNumbers& b) {
  const auto corner = [&](std::size_t i) { return InstantCorner{&signs, i}; };
  return corners_intersect(InstantTriangle{corner(a[0]), corner(a[1]), corner(a[2])},
                           InstantTriangle{corner(b[0]), corner(b[1]), corner(b[2])});
}

/// A time at which two moving triangles may first meet.
struct Candidate {
  CriticalTime time;
  std::size_t polynomial = MovingPolynomials::kCount;  ///< a polynomial with a root then, if known
};

/// Critical times of all polynomials of one degree: at most 45, 120 or 45.
class Candidates {
 public:
  explicit Candidates(MovingPolynomials& polynomials) {
    constexpr std::size_t kFlat = MovingPolynomials::kOrient3d;
    constexpr std::size_t kInLine = kFlat + MovingPolynomials::kOrient2d;
    if (!add(polynomials, 0, kFlat) && !add(polynomials, kFlat, kInLine))
      add(polynomials, kInLine, MovingPolynomials::kCount);
    for (std::size_t i = 0; i < count_; ++i) order_[i] = &candidates_[i];
    std::sort(
        order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count_),
        [](const Candidate* p, const Candidate* q) { return p->time.above() < q->time.above(); });
  }

  /// In ascending order of their lower bounds.
  std::span<const Candidate* const> ordered() const { return {order_.data(), count_}; }

 private:
  /// Returns false if all of these polynomials are zero.
  bool add(MovingPolynomials& polynomials, std::size_t begin, std::size_t end) {
    bool any = false;
    CriticalTimes found;
    for (std::size_t number = begin; number < end; ++number) {
      any = any || !is_zero(polynomials[number]);
      find_critical_times(polynomials[number], found);
      for (std::size_t i = 0; i < found.count; ++i) {
        const auto& [time, is_root] = found.entries[i];
        candidates_[count_++] = {time, is_root ? number : MovingPolynomials::kCount};
      }
    }
    return any;
  }

  std::array<Candidate, 120> candidates_;
  std::array<const Candidate*, 120> order_{};
  std::size_t count_ = 0;
};

/// The first candidate for which `holds(candidate)`; null if there is none.
template <typename Holds>
const Candidate* first_of(const Candidates& candidates, const Holds& holds) {
  const Candidate* first = nullptr;
  for (const Candidate* candidate : candidates.ordered()) {
    if (first != nullptr && first->time.below() <= candidate->time.above()) break;
    if (first != nullptr && candidate->time.compare(first->time) >= 0) continue;
    if (holds(*candidate)) first = candidate;
  }
  return first;
}

/// The corners of a feature, of which some are repeated. `first` is 0 for triangle a, 3 for b.
inline std::array<std::size_t, 3> corners_of(const Feature& feature, std::size_t first) {
  const std::size_t i = feature.number, next = (i + 1) % 3;
  switch (feature.kind) {
    case FeatureKind::corner:
      return {first + i, first + i, first + i};
    case FeatureKind::edge:
      return {first + i, first + next, first + next};
    case FeatureKind::face:
      break;
  }
  return {first, first + 1, first + 2};
}

/// Sets `a` and `b` to the first pair of features for which `meet(corners_a, corners_b)`. Returns
/// false if there is none.
template <typename Meet>
bool find_feature_pair(Feature& a, Feature& b, const Meet& meet) {
  using Kind = FeatureKind;
  constexpr std::array<std::array<Kind, 2>, 6> kOrder = {{{Kind::corner, Kind::corner},
                                                          {Kind::corner, Kind::edge},
                                                          {Kind::edge, Kind::corner},
                                                          {Kind::corner, Kind::face},
                                                          {Kind::face, Kind::corner},
                                                          {Kind::edge, Kind::edge}}};
  const auto count = [](Kind kind) { return kind == Kind::face ? 1 : 3; };
  for (const auto& [kind_a, kind_b] : kOrder)
    for (int i = 0; i < count(kind_a); ++i)
      for (int k = 0; k < count(kind_b); ++k) {
        a = {kind_a, static_cast<std::uint8_t>(i)};
        b = {kind_b, static_cast<std::uint8_t>(k)};
        if (meet(corners_of(a, 0), corners_of(b, 3))) return true;
      }
  return false;
}

}  // namespace pelt::detail
