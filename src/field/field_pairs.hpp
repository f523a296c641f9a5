#pragma once

/// Pairs of a posed triangle and one of a height field that wait until there are eight for the
/// certified float test (triangle_triage.hpp); the exact predicate decides what it leaves.

#include <pelt/collide.hpp>

#include "base/target.hpp"
#include "field/field_cells.hpp"
#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "query/lanes.hpp"
#include "query/stack.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_TARGET {

/// A posed triangle where it lies.
struct PosedTriangle {
  std::uint32_t number;     ///< the caller's
  const float* corners[3];  ///< four floats each
};

class FieldPairs {
 public:
  FieldPairs(Stack<Contact>& contacts, QueryStats& work) : contacts_(contacts), work_(work) {}

  void add(const PosedTriangle& posed, const FieldTriangle& field) {
    posed_[count_] = posed;
    field_[count_] = field;
    if (++count_ == kBatch) flush();
  }

  /// Tests what waits.
  void flush() {
    if (count_ == 0) return;
    for (std::uint32_t i = count_; i < kBatch; ++i) posed_[i] = posed_[0], field_[i] = field_[0];
    test();
    count_ = 0;
  }

 private:
  static constexpr std::uint32_t kBatch = 8;

  void test() {
    work_.triangle_pairs += count_;
    TrianglePairs8 pairs;
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.a[k] = corner8([&](std::uint32_t i) { return posed_[i].corners[k]; });
      pairs.b[k] = corner8([&](std::uint32_t i) { return field_[i].corners[k]; });
    }
    const Triage verdict = triage(pairs);
    for (SetBits lane(((1u << count_) - 1) & ~verdict.apart); lane; ++lane)
      if ((verdict.intersecting >> *lane & 1) != 0 || touch(*lane))
        contacts_.push(Contact{posed_[*lane].number, field_[*lane].number});
  }

  template <typename Corner>
  static Points8 corner8(const Corner& corner) {
    const auto at = [&](std::uint32_t i) { return load4(corner(i)); };
    return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  }

  bool touch(std::uint32_t i) const {
    TriangleCorners a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      const float *p = posed_[i].corners[k], *q = field_[i].corners[k];
      a[k] = {p[0], p[1], p[2]};
      b[k] = {q[0], q[1], q[2]};
    }
    return triangles_intersect(a, b);
  }

  PosedTriangle posed_[kBatch];
  FieldTriangle field_[kBatch];
  std::uint32_t count_ = 0;
  Stack<Contact>& contacts_;
  QueryStats& work_;
};

}  // namespace PELT_TARGET
}  // namespace pelt::detail
