#pragma once

#include "evaluation/rivals/stages.hpp"

#include <cstdint>
#include <vector>

namespace pelt::rivals {

/// Tests the pairs of triangles that a method finds, and counts them.
class PairTests {
 public:
  PairTests(const PosedMesh& a, const PosedMesh& b, std::vector<Contact>& contacts,
            std::uint32_t max_contacts)
      : a_(a), b_(b), touching_(active_touching()), contacts_(contacts), left_(max_contacts) {}

  /// Tests a pair now or together with later ones. Add each pair once.
  void add(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    waiting_[count_++] = {triangle_a, triangle_b};
    if (count_ == kPairsAtOnce) test();
  }

  /// Whether the limit on contacts is reached; other pairs are ignored.
  bool full() const { return left_ == 0; }

  /// Tests the pending pairs.
  void test() {
    if (count_ > 0 && !full()) {
      tested_ += count_;
      report(touching_(a_, b_, waiting_, count_));
    }
    count_ = 0;
  }

  /// The same after the last pair. Returns the number of tested pairs, and whether max_contacts was
  /// reached.
  QueryStats finish() {
    test();
    QueryStats work;
    work.triangle_pairs = tested_;
    work.cut_short = full();
    return work;
  }

 private:
  void report(unsigned lanes) {
    for (std::uint32_t lane = 0; lanes >> lane != 0 && !full(); ++lane) {
      if ((lanes >> lane & 1) == 0) continue;
      contacts_.push_back(waiting_[lane]);
      --left_;
    }
  }

  PosedMesh a_, b_;
  Touching* touching_;
  std::vector<Contact>& contacts_;
  std::uint32_t left_;
  std::uint32_t count_ = 0;
  std::uint64_t tested_ = 0;
  Contact waiting_[kPairsAtOnce] = {};
};

}  // namespace pelt::rivals
