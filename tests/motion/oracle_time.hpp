#pragma once

/// Exact times at which polynomials with numbers of GMP are zero, and numbers at such times.

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pelt::test {

/// Coefficients, of which the last is not zero, or none for the zero polynomial.
using IntegerPolynomial = std::vector<mpz_class>;

inline void trim(IntegerPolynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

inline IntegerPolynomial operator-(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  IntegerPolynomial result = p;
  result.resize(std::max(p.size(), q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) result[i] -= q[i];
  trim(result);
  return result;
}

inline IntegerPolynomial operator*(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  if (p.empty() || q.empty()) return {};
  IntegerPolynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < q.size(); ++k) result[i + k] += p[i] * q[k];
  return result;
}

/// Precondition: q divides p.
inline IntegerPolynomial exact_quotient(IntegerPolynomial p, const IntegerPolynomial& q) {
  if (p.empty()) return {};
  IntegerPolynomial quotient(p.size() - q.size() + 1);
  while (!p.empty()) {
    const std::size_t shift = p.size() - q.size();
    const mpz_class factor = p.back() / q.back();
    quotient[shift] = factor;
    for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] -= factor * q[i];
    trim(p);
  }
  return quotient;
}

/// Divides by the greatest common divisor of the coefficients.
inline void make_primitive(IntegerPolynomial& p) {
  mpz_class content;
  for (const mpz_class& c : p) content = gcd(content, c);
  for (mpz_class& c : p) c /= content;
}

/// The greatest common divisor of two polynomials over the rationals, primitive.
inline IntegerPolynomial greatest_common_divisor(IntegerPolynomial p, IntegerPolynomial q) {
  while (!q.empty()) {
    while (p.size() >= q.size()) {
      const std::size_t shift = p.size() - q.size();
      const mpz_class lead = p.back();
      for (mpz_class& c : p) c *= q.back();
      for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] -= lead * q[i];
      trim(p);
    }
    make_primitive(p);
    std::swap(p, q);
  }
  make_primitive(p);
  return p;
}

inline IntegerPolynomial derivative(const IntegerPolynomial& p) {
  IntegerPolynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned>(i));
  return result;
}

/// The sign of p(m / 2^k).
inline int sign_at(const IntegerPolynomial& p, const mpz_class& m, unsigned k) {
  mpz_class value;
  for (std::size_t i = p.size(); i-- > 0;)
    value = value * m + (p[i] << k * static_cast<unsigned>(p.size() - 1 - i));
  return sgn(value);
}

/// A root of a polynomial without multiple roots: m / 2^k, or the only one between m / 2^k and
/// (m + 1) / 2^k.
class OracleTime {
 public:
  OracleTime(IntegerPolynomial f, mpz_class m, unsigned k, bool is_point)
      : f_(std::move(f)),
        m_(std::move(m)),
        k_(k),
        is_point_(is_point),
        sign_at_low_(is_point ? 0 : sign_at(f_, m_, k_)) {}

  int sign_of(const IntegerPolynomial& g) {
    if (g.empty()) return 0;
    for (bool is_tested = false;; halve()) {
      if (is_point_) return sign_at(g, m_, k_);
      if (const int sign = sign_between(g)) return sign;
      if (k_ < kSmall || is_tested) continue;
      if (is_root_of(greatest_common_divisor(f_, g))) return 0;
      is_tested = true;
    }
  }

  /// -1, 0 or 1 if this time is before, equal to or after the other.
  int compare(OracleTime& other) {
    for (bool is_tested = false;; halve(), other.halve()) {
      if (other.is_point_) return compare_number(other.m_, other.k_);
      if (is_point_) return -other.compare_number(m_, k_);
      while (k_ < other.k_ && !is_point_) halve();
      while (other.k_ < k_ && !other.is_point_) other.halve();
      if (is_point_ || other.is_point_) continue;
      if (const int order = cmp(m_, other.m_)) return order < 0 ? -1 : 1;
      if (k_ < kSmall || is_tested) continue;
      if (is_root_of(greatest_common_divisor(f_, other.f_))) return 0;
      is_tested = true;
    }
  }

  /// Whether this is known to be m / 2^k.
  bool is_dyadic() const { return is_point_; }

  /// p(m / 2^k) 2^k. Precondition: is_dyadic(), and p is linear.
  mpz_class value_of(const IntegerPolynomial& p) const {
    mpz_class value;
    if (!p.empty()) value = p[0] << k_;
    if (p.size() > 1) value += p[1] * m_;
    return value;
  }

  float rounded_down() {
    while (true) {
      const float x = float_below(mpq_class(is_point_ ? m_ : m_ + 1) / power(k_));
      const mpq_class number(x);
      const auto exponent = static_cast<unsigned>(mpz_sizeinbase(number.get_den_mpz_t(), 2)) - 1;
      if (compare_number(number.get_num(), exponent) >= 0) return x;
      halve();
    }
  }

 private:
  /// Halvings of the step after which equality is tested: most numbers differ before.
  static constexpr unsigned kSmall = 16;

  static mpq_class power(unsigned k) { return mpq_class(mpz_class(1) << k); }

  /// Whether a divisor of f has its root in the interval.
  bool is_root_of(const IntegerPolynomial& divisor) const {
    return divisor.size() > 1 && sign_at(divisor, m_, k_) * sign_at(divisor, m_ + 1, k_) < 0;
  }

  /// The order of this time and m / 2^k.
  int compare_number(const mpz_class& m, unsigned k) const {
    const mpz_class x = m << k_, low = m_ << k, high = is_point_ ? low : (m_ + 1) << k;
    if (is_point_ && x == low) return 0;
    if (x <= low) return 1;
    if (x >= high) return -1;
    const int sign = sign_at(f_, m, k);
    if (sign == 0) return 0;
    return sign == sign_at_low_ ? 1 : -1;
  }

  void halve() {
    if (is_point_) return;
    m_ = 2 * m_ + 1;
    ++k_;
    const int sign = sign_at(f_, m_, k_);
    if (sign == 0) is_point_ = true;
    if (sign == -sign_at_low_) --m_;
  }

  /// The sign of g if it is constant on the interval by Horner's rule with bounds; otherwise 0.
  int sign_between(const IntegerPolynomial& g) const {
    mpz_class least, greatest;
    const mpz_class next = m_ + 1;
    for (std::size_t i = g.size(); i-- > 0;) {
      const mpz_class term = g[i] << k_ * static_cast<unsigned>(g.size() - 1 - i);
      least = least * (least < 0 ? next : m_) + term;
      greatest = greatest * (greatest < 0 ? m_ : next) + term;
    }
    return least > 0 ? 1 : greatest < 0 ? -1 : 0;
  }

  static float float_below(const mpq_class& x) {
    auto result = static_cast<float>(x.get_d());
    while (mpq_class(result) > x) result = std::nextafter(result, 0.0f);
    return result;
  }

  IntegerPolynomial f_;
  mpz_class m_;
  unsigned k_;
  bool is_point_;
  int sign_at_low_;  ///< of f at m / 2^k, unless this is the root
};

/// Appends the roots of p in (0, 1], by Descartes' rule and bisection.
class OracleRoots {
 public:
  static void append(IntegerPolynomial p, std::vector<OracleTime>& roots) {
    if (p.size() < 2 || (sign_at(p, 1, 0) != 0 && OracleRoots(p, roots).sign_changes(0, 0) == 0))
      return;
    make_primitive(p);
    const IntegerPolynomial f = exact_quotient(p, greatest_common_divisor(p, derivative(p)));
    if (sign_at(f, 1, 0) == 0) roots.emplace_back(f, 1, 0, true);
    OracleRoots(f, roots).search(0, 0);
  }

 private:
  OracleRoots(const IntegerPolynomial& f, std::vector<OracleTime>& roots) : f_(f), roots_(roots) {}

  /// Searches between m / 2^k and (m + 1) / 2^k.
  void search(const mpz_class& m, unsigned k) {
    const int changes = sign_changes(m, k);
    if (changes == 0) return;
    if (changes == 1 && sign_at(f_, m, k) != 0 && sign_at(f_, m + 1, k) != 0) {
      roots_.emplace_back(f_, m, k, false);
      return;
    }
    if (sign_at(f_, 2 * m + 1, k + 1) == 0) roots_.emplace_back(f_, 2 * m + 1, k + 1, true);
    search(2 * m, k + 1);
    search(2 * m + 1, k + 1);
  }

  /// Sign changes in the coefficients of (1 + x)^n f((m + (m + 1) x) / (2^k (1 + x))): at least the
  /// number of roots in the open interval, and equal to it if it is 0 or 1.
  int sign_changes(const mpz_class& m, unsigned k) const {
    const auto n = static_cast<unsigned>(f_.size() - 1);
    IntegerPolynomial sum(n + 1);
    for (unsigned i = 0; i <= n; ++i) {
      IntegerPolynomial term = {f_[i] << k * (n - i)};
      for (unsigned j = 0; j < i; ++j) term = term * IntegerPolynomial{m, m + 1};
      for (unsigned j = i; j < n; ++j) term = term * IntegerPolynomial{1, 1};
      for (std::size_t j = 0; j < term.size(); ++j) sum[j] += term[j];
    }
    int changes = 0, previous = 0;
    for (const mpz_class& c : sum) {
      if (sgn(c) == 0) continue;
      changes += previous == -sgn(c);
      previous = sgn(c);
    }
    return changes;
  }

  const IntegerPolynomial& f_;
  std::vector<OracleTime>& roots_;
};

/// A polynomial as a number, whose value at one time counts in comparisons.
class NumberAt {
 public:
  NumberAt() = default;
  NumberAt(int value) : polynomial_{mpz_class(value)} { trim(polynomial_); }
  NumberAt(IntegerPolynomial polynomial, OracleTime* time)
      : polynomial_(std::move(polynomial)), time_(time) {}

  friend NumberAt operator-(const NumberAt& a, const NumberAt& b) {
    return {a.polynomial_ - b.polynomial_, either(a, b)};
  }
  friend NumberAt operator-(const NumberAt& a) {
    return {IntegerPolynomial{} - a.polynomial_, a.time_};
  }
  NumberAt& operator-=(const NumberAt& b) { return *this = *this - b; }
  friend NumberAt operator*(const NumberAt& a, const NumberAt& b) {
    return {a.polynomial_ * b.polynomial_, either(a, b)};
  }
  /// Precondition: b divides a.
  friend NumberAt operator/(const NumberAt& a, const NumberAt& b) {
    return {exact_quotient(a.polynomial_, b.polynomial_), either(a, b)};
  }
  friend bool operator==(const NumberAt& a, int) { return a.sign() == 0; }
  friend bool operator>(const NumberAt& a, int) { return a.sign() > 0; }
  friend bool operator<(const NumberAt& a, int) { return a.sign() < 0; }

 private:
  static OracleTime* either(const NumberAt& a, const NumberAt& b) {
    return a.time_ != nullptr ? a.time_ : b.time_;
  }

  int sign() const {
    if (time_ == nullptr) return polynomial_.empty() ? 0 : sgn(polynomial_[0]);
    return time_->sign_of(polynomial_);
  }

  IntegerPolynomial polynomial_;
  OracleTime* time_ = nullptr;
};

}  // namespace pelt::test
