#pragma once

/// Tests one pair of moving triangles in eight pieces of its time at once, one in each lane.
///
///     times    0                                       1
///     first    |    |    |    | ?  | ?  |    |    |    |   ?: undecided pieces
///     then                    |_|_|_|_|_|_|_|_|            from the first to the last of these

#include "motion/bernstein_weights.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_signs.hpp"

#include <bit>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

class EightPieces {
 public:
  /// The pair in one lane of determinants on [0, 1].
  EightPieces(const Cubics8& cubics, const MovingCertainties& certainly, unsigned lane)
      : certainly_(certainly.of_lane(lane)) {
    for (const auto cubic :
         {&Cubics8::uvw, &Cubics8::uvr, &Cubics8::uvs, &Cubics8::rsw, &Cubics8::rsu, &Cubics8::rsv,
          &Cubics8::uwr, &Cubics8::uws, &Cubics8::vwr, &Cubics8::vws})
      for (std::size_t k = 0; k < 4; ++k)
        (cubics_.*cubic)[k] = Float8(lane_of((cubics.*cubic)[k], lane));
  }

  /// Decides, if this is certain, whether the triangles intersect.
  CertainAnswer test() {
    for (int round = 0; round < kRounds; ++round) {
      const CertainAnswer answer = test_pieces();
      if (answer != CertainAnswer::unknown) return answer;
    }
    return CertainAnswer::unknown;
  }

 private:
  /// With more, times would not be multiples of 1/128 (bernstein_weights.hpp).
  static constexpr int kRounds = 2;

  CertainAnswer test_pieces() {
    const float step = (end_ - start_) / 8;
    alignas(32) float starts[8];
    for (int k = 0; k < 8; ++k) starts[k] = start_ + static_cast<float>(k) * step;
    const Float8 start = load8(starts), end = start + Float8(step);
    const BernsteinWeights weights[] = {
        BernsteinWeights(start), {start, start, end}, {start, end, end}, BernsteinWeights(end)};
    const unsigned left = kAllLanes & ~CertainlyApart([&](std::size_t k) {
                                         return each_of(cubics_, weights[k]);
                                       }).lanes(certainly_);
    if (left == 0) return CertainAnswer::no;
    const BernsteinWeights middle(start + Float8(step / 2));
    if (certainly_intersecting(Orientations8(each_of(cubics_, middle)), certainly_) != 0)
      return CertainAnswer::yes;
    start_ = starts[std::countr_zero(left)];
    end_ = starts[std::bit_width(left) - 1] + step;
    return CertainAnswer::unknown;
  }

  Cubics8 cubics_;
  MovingCertainties certainly_;
  float start_ = 0, end_ = 1;  ///< outside of these times, the triangles are certainly apart
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
