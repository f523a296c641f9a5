#pragma once

/// The times at which two moving triangles may first meet (moving_pair.cpp explains why).

#include "motion/instant_signs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace pelt::detail {

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

}  // namespace pelt::detail
