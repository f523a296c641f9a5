#pragma once

/// Collects pairs of a posed triangle and a triangle of a height field until there are eight for
/// the certified float test (triangle_triage.hpp). The exact predicate decides the rest.

#include <pelt/collide.hpp>

#include "base/instruction_set.hpp"
#include "field/field_cells.hpp"
#include "query/stack.hpp"
#include "query/triangle_batch.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A posed triangle, by pointers to its corners.
struct PosedTriangle {
  std::uint32_t number;     ///< the caller's number
  const float* corners[3];  ///< four floats each
};

class FieldPairs {
 public:
  FieldPairs(Stack<Contact>& contacts, QueryStats& work) : contacts_(contacts), work_(work) {}

  void add(const PosedTriangle& posed, const FieldTriangle& field) {
    waiting_.add({posed, field});
    if (waiting_.is_full()) flush();
  }

  /// Tests the waiting pairs.
  void flush() {
    if (waiting_.count() == 0) return;
    waiting_.pad();
    test();
    waiting_.clear();
  }

 private:
  struct Pair {
    PosedTriangle posed;
    FieldTriangle field;
  };

  void test() {
    work_.triangle_pairs += waiting_.count();
    TrianglePairs8 pairs;
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.a[k] = gather_points([&](std::uint32_t i) { return waiting_[i].posed.corners[k]; });
      pairs.b[k] = gather_points([&](std::uint32_t i) { return waiting_[i].field.corners[k]; });
    }
    const unsigned kept = (1u << waiting_.count()) - 1;
    const Triage verdict = triage(pairs);
    const auto posed = [&](unsigned lane) {
      return corners_at([&](std::size_t k) { return waiting_[lane].posed.corners[k]; });
    };
    const auto field = [&](unsigned lane) {
      return corners_at([&](std::size_t k) { return waiting_[lane].field.corners[k]; });
    };
    const unsigned exact = decide_exactly(verdict, kept, posed, field);
    for (SetBits lane((kept & verdict.intersecting) | exact); lane; ++lane)
      contacts_.push(Contact{waiting_[*lane].posed.number, waiting_[*lane].field.number});
  }

  Batch8<Pair> waiting_;
  Stack<Contact>& contacts_;
  QueryStats& work_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
