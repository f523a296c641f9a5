#pragma once

/// Signs of polynomials of a moving triangle and a region, at one time or in a piece of time.
///
/// `Source` computes a polynomial from `Rounded` numbers in a range of time, and from polynomials
/// of time, for the templates of capsule_by_signs.hpp and faces_by_signs.hpp.

#include "geometry/critical_time.hpp"
#include "geometry/instant_signs.hpp"
#include "geometry/moving_filter.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <type_traits>

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

/// A coordinate at a time.
inline Rounded at_time(double from, double to, const Rounded& time) {
  return Rounded(from) + time * (Rounded(to) - Rounded(from));
}

/// A polynomial of time with rounded coefficients.
struct RoundedPolynomial {
  static constexpr std::size_t kDegree = Sextic::kDegree;

  std::array<Rounded, kDegree + 1> coefficients = {Rounded(0), Rounded(0), Rounded(0), Rounded(0),
                                                   Rounded(0), Rounded(0), Rounded(0)};
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

/// Searches the time from 0 to 1 in pieces. `is_apart(low, high)` returns whether a triangle and a
/// region are certainly apart at all times of a piece, `touch(time)` whether they certainly touch.
template <typename IsApart, typename Touch>
CertainAnswer search_pieces(const IsApart& is_apart, const Touch& touch) {
  constexpr double kLeastWidth = 1.0 / 64;
  for (double low = 0, width = 1; low < 1;) {
    if (is_apart(low, low + width)) {
      low += width;
      width = std::min(2 * width, 1 - low);
    } else {
      width /= 2;
      if (touch(low + width)) return CertainAnswer::yes;
      if (width < kLeastWidth) return CertainAnswer::unknown;
    }
  }
  return CertainAnswer::no;
}

}  // namespace pelt::detail
