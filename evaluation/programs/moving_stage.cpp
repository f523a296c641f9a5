/// Compiled once for each instruction set.
#include "evaluation/programs/moving_stage.hpp"

#include "base/instruction_set.hpp"
#include "motion/moving_boxes.hpp"
#include "motion/moving_pairs.hpp"
#include "motion/moving_triage.hpp"
#include "query/pair_descent.hpp"
#include "query/triangle_batch.hpp"

namespace pelt::programs {
namespace PELT_INSTRUCTION_SET {
namespace {

using detail::CertainAnswer;
using detail::kBatch;
using detail::MovingPairs8;

PaddedCorners padded(const detail::TriangleCorners& corners) {
  PaddedCorners result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = {corners[k].x, corners[k].y, corners[k].z, 0};
  return result;
}

/// The rule of `collide` of motions, but pairs of triangles are only collected.
class Collecting : public detail::MovingOverlap {
 public:
  Collecting(const detail::Tree& a, const detail::Tree& b,
             detail::Stack<MovingCandidate>& candidates)
      : candidates_(candidates), pairs_(a, b) {}

  static bool is_full() { return false; }
  static bool is_impatient() { return false; }

  void test(const detail::MovingCluster& a, const detail::MovingCluster& b) {
    pairs_.add(a, b, detail::OverlapUntil{1}, [this] { flush(); });
  }

  void flush() {
    for (std::uint32_t lane = 0; lane < pairs_.count(); ++lane) {
      const detail::MovingTriangle a = pairs_.triangle_a(lane), b = pairs_.triangle_b(lane);
      candidates_.push({padded(a.from), padded(a.to), padded(b.from), padded(b.to)});
    }
    pairs_.clear();
  }

 private:
  detail::Stack<MovingCandidate>& candidates_;
  detail::WaitingMovingPairs pairs_;
};

void collect(const detail::MovingTree& a, const detail::MovingTree& b, detail::Scratch& scratch,
             detail::Stack<MovingCandidate>& candidates) {
  MovingStats work;
  if (!detail::begin_descent(a, b, work)) return;
  Collecting rule(a.tree, b.tree, candidates);
  detail::descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  rule.flush();
}

/// The corners of eight pairs, or of fewer, of which the first one is repeated.
MovingPairs8 corners8(std::span<const MovingCandidate> candidates) {
  const auto corner = [&](PaddedCorners MovingCandidate::*side, std::size_t k) {
    return detail::gather_points([&](std::uint32_t lane) {
      return (candidates[lane < candidates.size() ? lane : 0].*side)[k].data();
    });
  };
  MovingPairs8 pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    pairs.from.a[k] = corner(&MovingCandidate::a_from, k);
    pairs.from.b[k] = corner(&MovingCandidate::b_from, k);
    pairs.to.a[k] = corner(&MovingCandidate::a_to, k);
    pairs.to.b[k] = corner(&MovingCandidate::b_to, k);
  }
  return pairs;
}

void decide(std::span<const MovingCandidate> candidates, bool finds_meetings,
            CertainAnswer* answers) {
  for (std::size_t first = 0; first < candidates.size(); first += kBatch) {
    const std::size_t left = candidates.size() - first;
    const std::size_t count = left < kBatch ? left : kBatch;
    const unsigned kept = (1u << count) - 1;
    const MovingPairs8 pairs = corners8(candidates.subspan(first, count));
    const unsigned at_start = detail::triage(pairs.from).intersecting;
    const detail::Triage verdict = detail::moving_triage(pairs, detail::times_of_boxes(pairs),
                                                         finds_meetings ? kept & ~at_start : 0);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const unsigned bit = 1u << lane;
      answers[first + lane] = ((at_start | verdict.intersecting) & bit) != 0 ? CertainAnswer::yes
                              : (verdict.apart & bit) != 0                   ? CertainAnswer::no
                                                           : CertainAnswer::unknown;
    }
  }
}

}  // namespace

const MovingStage kMovingStage = {collect, decide};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::programs
