#pragma once

/// Searches a piece of the step for the first time at which two triangles intersect that are
/// disjoint at time 0.
///
/// This time is a root of a determinant whose features intersect then (`moving_pair.cpp`). Almost
/// always, each determinant that is not constant in sign has one sign change in its coefficients
/// on the piece, and therefore one root. The roots are approximated and enclosed between times at
/// which the signs are certain. Where enclosures are disjoint, the order of roots is certain, and
/// with it the sign of each determinant at the roots of the others: it is that at the start of the
/// piece before the determinant's own root, and that at the end after it. These signs decide
/// whether the features of a root intersect.
///
/// The first root at which they do is the first time if each other root is certainly later or has
/// disjoint features. No other features intersect then, so these are also the first ones in the
/// order of `FirstMeeting`: the corner is inside the face, and the edges cross between their ends.

#include "motion/moving_filter.hpp"
#include "motion/moving_pieces.hpp"

#include <bit>
#include <cstddef>

namespace pelt::detail {
namespace moving {

/// Half the width of an enclosure, as a part of the piece.
inline constexpr double kHalfWidth = 0x1p-24;

/// Parts of the piece at which the cubics are zero, by three steps of Newton's method. If it
/// does not converge, the root is not enclosed.
inline Fifteen approximate_roots(const Cubics& p) {
  const Fifteen c = 3 * (p[1] - p[0]), b = 3 * (p[0] - p[1] + (p[2] - p[1]));
  const Fifteen a = p[3] - p[0] + 3 * (p[1] - p[2]);
  const Fifteen two_b = 2 * b, three_a = 3 * a;
  Fifteen x = p[0] / (p[0] - p[3]);
  for (int step = 0; step < 3; ++step) {
    const Fifteen value = ((a * x + b) * x + c) * x + p[0];
    const Fifteen slope = (three_a * x + two_b) * x + c;
    x = x - value / slope;
  }
  return min(max(x, Fifteen(kHalfWidth)), Fifteen(1 - kHalfWidth));
}

/// A root of a determinant in a piece, near a part of it from 0 to 1.
struct Root {
  unsigned determinant = 0;
  double part = 0;
};

class PieceSearch {
 public:
  PieceSearch(const Cubics& cubics, const Fifteen& errors)
      : first_(cubics[0], errors), last_(cubics[3], errors) {
    const Signs second(cubics[1], errors), third(cubics[2], errors);
    constant_ = first_ & second & third & last_;
    left_ = kAll & ~(constant_.positive | constant_.negative | Meetings(constant_).never);
    parts_ = approximate_roots(cubics);
    starts_ = parts_ - Fifteen(kHalfWidth);
    ends_ = parts_ + Fifteen(kHalfWidth);
    const unsigned with_one_root =
        equal(first_, -last_) & (equal(first_, second) | equal(third, last_));
    enclosed_ = with_one_root & equal(first_, Signs(values_at(starts_, cubics), errors)) &
                equal(last_, Signs(values_at(ends_, cubics), errors));
  }

  /// Whether the features of some root intersect then. If so, sets `root`.
  CertainAnswer find(Root& root) {
    if ((left_ & ~enclosed_) != 0) return CertainAnswer::unknown;
    while (left_ != 0) {
      root = take_root();
      const CertainAnswer answer = meet(root);
      if (answer != CertainAnswer::no) return answer;
    }
    return CertainAnswer::no;
  }

  /// The same, for the first such root. Returns unknown if another one may be earlier or equal.
  CertainAnswer find_first(Root& root) {
    const CertainAnswer answer = find(root);
    if (answer != CertainAnswer::yes) return answer;
    left_ &= ~later_than(root);
    Root other;
    return find(other) == CertainAnswer::no ? CertainAnswer::yes : CertainAnswer::unknown;
  }

 private:
  static constexpr unsigned kAll = (1u << kDeterminants) - 1;

  /// Removes the root that seems to be the first one.
  Root take_root() {
    Root root = {0, 2};
    for (unsigned rest = left_; rest != 0; rest &= rest - 1) {
      const auto determinant = static_cast<unsigned>(std::countr_zero(rest));
      const double part = parts_[determinant];
      if (part < root.part) root = {determinant, part};
    }
    left_ &= ~(1u << root.determinant);
    return root;
  }

  /// Whether the features intersect at a root.
  CertainAnswer meet(const Root& root) const {
    const Meetings meetings(signs_at(root));
    const unsigned bit = 1u << root.determinant;
    if ((meetings.never & bit) != 0) return CertainAnswer::no;
    return (meetings.always & bit) != 0 ? CertainAnswer::yes : CertainAnswer::unknown;
  }

  /// The signs of the other determinants at a root.
  Signs signs_at(const Root& root) const {
    const unsigned before = later_than(root), after = earlier_than(root);
    return {constant_.positive | (first_.positive & before) | (last_.positive & after),
            constant_.negative | (first_.negative & before) | (last_.negative & after)};
  }

  /// The determinants whose roots are certainly later, or certainly earlier.
  unsigned later_than(const Root& root) const {
    return enclosed_ & less(Fifteen(root.part + kHalfWidth), starts_);
  }
  unsigned earlier_than(const Root& root) const {
    return enclosed_ & less(ends_, Fifteen(root.part - kHalfWidth));
  }

  Signs first_, last_;       ///< at the start and at the end of the piece
  Signs constant_ = {0, 0};  ///< throughout the piece
  unsigned left_;            ///< determinants whose roots are not yet looked at
  unsigned enclosed_ = 0;    ///< those with one root, between a start and an end
  Fifteen parts_, starts_, ends_;
};

}  // namespace moving
}  // namespace pelt::detail
