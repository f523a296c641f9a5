#include "paper/weight_corners.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt::paper {
namespace {

double sum_of_lows(std::span<const WeightInterval> intervals) {
  double sum = 0;
  for (const WeightInterval& interval : intervals) sum += interval.low;
  return sum;
}

/// The corners of the simplex that is bounded by the lower ends alone.
void append_simplex_corners(std::span<const WeightInterval> intervals,
                            std::vector<double>& corners) {
  const double rest = 1 - sum_of_lows(intervals);
  for (std::size_t a = 0; a < intervals.size(); ++a)
    for (std::size_t i = 0; i < intervals.size(); ++i)
      corners.push_back(intervals[i].low + (i == a ? rest : 0));
}

/// "Testing all intersections": all weights of a corner but one are at an end of their interval.
class Enumeration {
 public:
  Enumeration(std::span<const WeightInterval> intervals, std::vector<double>& corners)
      : intervals_(intervals), corners_(corners), first_(corners.size()) {}

  void run() {
    for (free_ = 0; free_ < intervals_.size(); ++free_) choose(0, 1);
  }

 private:
  /// Sets weights i, i + 1, ... to either end of their intervals; `rest` is 1 less the weights
  /// before.
  void choose(std::size_t i, double rest) {
    if (i == intervals_.size()) {
      take_free_weight(rest);
    } else if (i == free_) {
      choose(i + 1, rest);
    } else {
      const auto [low, high] = intervals_[i];
      corner_[i] = low;
      choose(i + 1, rest - low);
      if (high == low) return;
      corner_[i] = high;
      choose(i + 1, rest - high);
    }
  }

  void take_free_weight(double weight) {
    const auto [low, high] = intervals_[free_];
    if (weight < low - kWeightTolerance || weight > high + kWeightTolerance) return;
    corner_[free_] = weight;
    if (!is_known()) corners_.insert(corners_.end(), corner_.begin(), corner_.begin() + size());
  }

  /// The enumeration finds a corner once for every weight that is at an end of its interval there.
  bool is_known() const {
    for (std::size_t c = first_; c < corners_.size(); c += intervals_.size())
      if (std::equal(corner_.begin(), corner_.begin() + size(), corners_.begin() + index(c),
                     [](double x, double y) { return std::fabs(x - y) <= kWeightTolerance; }))
        return true;
    return false;
  }

  std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(intervals_.size()); }
  static std::ptrdiff_t index(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  std::span<const WeightInterval> intervals_;
  std::vector<double>& corners_;
  std::size_t first_, free_ = 0;
  std::array<double, kMaxEnumeratedJoints> corner_ = {};
};

}  // namespace

void append_weight_corners(std::span<const WeightInterval> intervals,
                           std::vector<double>& corners) {
  const std::size_t before = corners.size();
  if (intervals.size() > kMaxEnumeratedJoints)
    append_simplex_corners(intervals, corners);
  else
    Enumeration(intervals, corners).run();
  PELT_ASSERT(corners.size() > before);
}

}  // namespace pelt::paper
