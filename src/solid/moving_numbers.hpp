#pragma once

/// Signs of polynomials of a moving triangle and a region, at one time or in a piece of time.
///
/// `Source` computes a polynomial from `Rounded` numbers in a range of time, and from polynomials
/// of time, for the templates of capsule_by_signs.hpp and faces_by_signs.hpp.

#include "exact/critical_time.hpp"
#include "motion/instants.hpp"
#include "solid/region_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>

namespace pelt::detail {

/// Exact signs at a root or at time 0, or just after it.
class RegionInstant {
 public:
  /// `root` is null for time 0.
  RegionInstant(const RootOf<Sextic>* root, Moment moment) : root_(root), moment_(moment) {}

  Rounded enclosure() const { return root_ == nullptr ? Rounded(0) : root_->enclosure(); }

  template <typename AnyPolynomial>
  int sign(const AnyPolynomial& polynomial) const {
    const std::optional<int> sign = polynomial(Rounded(0)).sign();
    if (sign && (*sign != 0 || moment_ == Moment::at)) return *sign;
    const Sextic exact = polynomial(Sextic());
    return moment_ == Moment::at
               ? sign_at_instant(exact)
               : sign_just_after(exact, [this](const Sextic& p) { return sign_at_instant(p); });
  }

 private:
  int sign_at_instant(const Sextic& p) const {
    return root_ == nullptr ? p.coefficients[0].sign() : root_->sign_of(p);
  }

  const RootOf<Sextic>* root_;
  Moment moment_;
};

/// Signs that are the same at all times from `low` to `high`, if they are certain.
class RegionPiece {
 public:
  RegionPiece(double low, double high) : time_(enclosure_of(low, high)) {}

  Rounded enclosure() const { return time_; }

  /// Returns 0 if the sign is not certain.
  template <typename AnyPolynomial>
  int sign(const AnyPolynomial& polynomial) const {
    const std::optional<int> sign = polynomial(Rounded(0)).sign();
    if (!sign) is_certain_ = false;
    return sign.value_or(0);
  }

  /// Whether all signs since the last call were certain.
  bool take_certain() const {
    const bool is_certain = is_certain_;
    is_certain_ = true;
    return is_certain;
  }

 private:
  Rounded time_;
  mutable bool is_certain_ = true;
};

/// A number that moves from `from` to `to`.
inline Rounded at_time(const Rounded& from, const Rounded& to, const Rounded& time) {
  return from + time * (to - from);
}

/// A polynomial of time with rounded coefficients.
struct RoundedPolynomial {
  static constexpr std::size_t kDegree = Sextic::kDegree;

  std::array<Rounded, kDegree + 1> coefficients;
  std::size_t degree = 0;  ///< higher coefficients are 0

  friend RoundedPolynomial operator+(RoundedPolynomial p, const RoundedPolynomial& q) {
    p.degree = std::max(p.degree, q.degree);
    for (std::size_t i = 0; i <= q.degree; ++i)
      p.coefficients[i] = p.coefficients[i] + q.coefficients[i];
    return p;
  }
  friend RoundedPolynomial operator-(RoundedPolynomial p, const RoundedPolynomial& q) {
    p.degree = std::max(p.degree, q.degree);
    for (std::size_t i = 0; i <= q.degree; ++i)
      p.coefficients[i] = p.coefficients[i] - q.coefficients[i];
    return p;
  }
  friend RoundedPolynomial operator*(const RoundedPolynomial& p, const RoundedPolynomial& q) {
    RoundedPolynomial result;
    result.degree = p.degree + q.degree;
    PELT_ASSERT(result.degree <= kDegree);
    for (std::size_t i = 0; i <= p.degree; ++i)
      for (std::size_t k = 0; k <= q.degree; ++k)
        result.coefficients[i + k] =
            result.coefficients[i + k] + p.coefficients[i] * q.coefficients[k];
    return result;
  }

  /// Whether the polynomial certainly has no root from 0 to 1: its coefficients in the basis of
  /// Bernstein (see bernstein_changes in critical_time.cpp) have one sign.
  bool certainly_has_no_root() const {
    RoundedPolynomial b;
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t k = i; k > 0; --k)
        b.coefficients[k] = b.coefficients[k] + b.coefficients[k - 1];
      b.coefficients[i] = b.coefficients[i] + coefficients[i];
    }
    int sum = 0;
    for (std::size_t i = 0; i <= degree; ++i) sum += b.coefficients[i].sign().value_or(0);
    return std::abs(sum) == static_cast<int>(degree) + 1;
  }
};

/// Margins for `just_before_root`, to try one after the other. The closer a root is, the larger is
/// the margin that rounding needs.
inline constexpr double kRootMargins[] = {0x1p-40, 0x1p-30, 0x1p-20, 0x1p-10, 0x1p-2};

/// Returns a time just before the root of a linear function, relative to the way from `low`, to
/// allow for rounding. The function is positive at `low`. Without a root before 1, returns 1.
inline double just_before_root(double low, double at_low, double at_end, double margin) {
  if (at_end >= at_low) return 1;
  const double way = (1 - low) * (at_low / (at_low - at_end)) * (1 - margin);
  return std::min(low + way, 1.0);
}

/// Follows a triangle that is apart from a region until it is about to touch it. Returns a time up
/// to which it is certainly apart. `Test`:
///   double apart_until(double low) const   a time up to which it is certainly apart, from `low` on
///   bool touches(double time) const        whether it certainly touches the region
template <typename Test>
double advance_certainly(const Test& test) {
  constexpr int kMostSteps = 40;
  constexpr double kLeastStep = 0x1p-38;
  double low = 0;
  for (int step = 0; step < kMostSteps && low < 1; ++step) {
    const double high = test.apart_until(low);
    if (high - low < kLeastStep) return high;
    low = high;
  }
  return low;
}

template <typename Test>
CertainAnswer certainly_touches(const Test& test) {
  const double low = advance_certainly(test);
  if (low >= 1) return CertainAnswer::no;
  for (const double later : {0x1p-20, 0x1p-10, 0x1p-5})
    if (test.touches(std::min(low + later, 1.0))) return CertainAnswer::yes;
  return CertainAnswer::unknown;
}

template <typename Test>
bool find_certain_first_touch(const Test& test, std::optional<FirstTouch>& touch) {
  touch.reset();
  const double low = advance_certainly(test);
  if (low >= 1) return true;
  const float nearest = static_cast<float>(low);
  const float time = double{nearest} > low ? std::nextafter(nearest, 0.0f) : nearest;
  const double before_next = std::nextafter(double{std::nextafter(time, 1.0f)}, 0.0);
  if (!test.touches(before_next)) return false;
  touch = {time, false};
  return true;
}

}  // namespace pelt::detail
