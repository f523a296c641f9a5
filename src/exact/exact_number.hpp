#pragma once

/// Exact signs of polynomials in float32 numbers. A polynomial is written once, as a template over
/// a type of numbers. It is evaluated with `Rounded` and, if that does not decide the sign, with
/// `Exact`.
///
/// Range, for degrees up to six. A float is a multiple of 2^-149 below 2^128, so the values of a
/// polynomial of degree d are multiples of 2^(-149 d), below 2^(128 d) times its number of
/// monomials; rounding to a double preserves this. At degree six, the values range from 2^-894 to
/// slightly above 2^768, so nothing here overflows or underflows, including Dekker's splitting.

#include "exact/exact_determinant.hpp"
#include "exact/predicates.hpp"

#include <cmath>
#include <optional>

namespace pelt::detail {

/// A double, with a bound of its error.
class Rounded {
 public:
  Rounded() = default;
  explicit Rounded(double exact) : value_(exact) {}

  /// A number that differs from `value` by at most `error`.
  static Rounded within(double value, double error) {
    Rounded result(value);
    result.error_ = error;
    return result;
  }

  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    return Rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Rounded operator-(const Rounded& a, const Rounded& b) {
    return Rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    return Rounded(a.value_ * b.value_, std::abs(a.value_) * b.error_ +
                                            std::abs(b.value_) * a.error_ + a.error_ * b.error_);
  }
  /// Precondition: the sign of `b` is certain.
  friend Rounded operator/(const Rounded& a, const Rounded& b) {
    const double value = a.value_ / b.value_;
    return Rounded(value, (a.error_ + std::abs(value) * b.error_) /
                              (std::abs(b.value_) - b.error_) * (1 + 0x1p-48));
  }

  double value() const { return value_; }
  double error() const { return error_; }

  /// Returns -1, 0 or 1 if the sign is certain.
  std::optional<int> sign() const {
    if (value_ > error_) return 1;
    if (value_ < -error_) return -1;
    if (error_ == 0) return 0;
    return std::nullopt;
  }

 private:
  /// A result rounded once, with the error `inherited` from its operands. A factor covers the few
  /// roundings of the bound itself, and a constant far below any value but zero covers its
  /// underflow.
  Rounded(double value, double inherited)
      : value_(value), error_((inherited + 0x1p-53 * std::abs(value)) * (1 + 0x1p-48)) {
    if (error_ != 0) error_ += 0x1p-1000;
  }

  double value_ = 0, error_ = 0;
};

/// An exact number.
class Exact {
 public:
  explicit Exact(double value) { sum_.add(value); }
  Exact(const Exact& other) { add(other); }
  Exact& operator=(const Exact&) = delete;

  friend Exact operator+(Exact a, const Exact& b) {
    a.add(b);
    return a;
  }
  friend Exact operator-(Exact a, const Exact& b) {
    for (const double term : b.sum_.terms()) a.sum_.add(-term);
    return a;
  }
  friend Exact operator*(const Exact& a, const Exact& b) {
    Exact product(0);
    for (const double s : a.sum_.terms())
      for (const double t : b.sum_.terms()) {
        const ExactProduct st(s, t);
        product.sum_.add(st.error);
        product.sum_.add(st.value);
      }
    return product;
  }

  int sign() const { return sum_.sign(); }

  /// Returns the number with an error below one unit in the last place.
  double rounded() const { return sum_.rounded(); }

 private:
  /// Terms do not overlap, so their number is at most the number of bits between the least and the
  /// largest number.
  static constexpr std::size_t kCapacity = 1728;

  void add(const Exact& other) {
    for (const double term : other.sum_.terms()) sum_.add(term);
  }

  ExactSum<kCapacity> sum_;
};

/// A point or vector of numbers.
template <typename Number>
struct Vector {
  Number x, y, z;

  explicit Vector(const Vec3& v)
      : x(static_cast<double>(v.x)), y(static_cast<double>(v.y)), z(static_cast<double>(v.z)) {}
  Vector(const Number& x_, const Number& y_, const Number& z_) : x(x_), y(y_), z(z_) {}

  friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
};

template <typename Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Number>
Number squared_length(const Vector<Number>& v) {
  return dot(v, v);
}

/// Returns the sign of a polynomial. `polynomial(number)` computes it with numbers of the given
/// type.
template <typename Polynomial>
int exact_sign(const Polynomial& polynomial) {
  if (const std::optional<int> sign = polynomial(Rounded(0)).sign()) return *sign;
  ++exact_sign_count();
  return polynomial(Exact(0)).sign();
}

}  // namespace pelt::detail
