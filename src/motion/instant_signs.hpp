#pragma once

#include "motion/moving_polynomials.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

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

}  // namespace pelt::detail
