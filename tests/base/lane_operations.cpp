/// Compiled once for each instruction set. The test itself runs on any machine.
#include "lane_operations.hpp"

#include "base/float8.hpp"
#include "base/short16.hpp"

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

LaneResults lane_operations(const float* a_floats, const float* b_floats) {
  const detail::Float8 a = detail::load8(a_floats), b = detail::load8(b_floats);
  LaneResults results;
  (a + b).store(results.sum);
  (a - b).store(results.difference);
  (a * b).store(results.product);
  (a * b + a).store(results.product_and_sum);
  min(a, b).store(results.least);
  max(a, b).store(results.most);
  abs(a).store(results.size);
  const detail::Mask8 less = a < b, at_most = b <= detail::Float8(1.0f);
  results.less = less.bits();
  results.less_equal = (a <= b).bits();
  results.both = (less & at_most).bits();
  results.either = (less | at_most).bits();
  results.one_of_both = (less ^ at_most).bits();
  select(less, a, b).store(results.chosen);
  detail::Float8(a_floats[3]).store(results.repeated);
  detail::pair8(a_floats[1], b_floats[6]).store(results.paired);
  detail::store4(results.low, a.low());
  detail::store4(results.high, a.high());
  detail::Float8(b.high(), a.low()).store(results.joined);
  detail::store4(results.folded, fold(a));
  return results;
}

ShortResults short_operations(const std::int16_t* a_shorts, const std::int16_t* b_shorts,
                              const float* floats) {
  const detail::Short16 a = detail::load16(a_shorts), b = detail::load16(b_shorts);
  ShortResults results;
  a.store(results.first);
  (a & b).store(results.both);
  detail::Short16(a_shorts[5]).store(results.repeated);
  truncate(detail::load8(floats), detail::load8(floats + 8)).store(results.truncated);
  results.greater = (a > b).bits();
  results.equal = (a == b).bits();
  results.either = ((a > b) | (a == b)).bits();
  return results;
}

TurnedPoints turn_points(const float* points) {
  detail::Float4 p[8];
  for (int i = 0; i < 8; ++i) p[i] = detail::load4(points + 4 * i);
  const detail::Points8 turned = detail::transpose8(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
  TurnedPoints results;
  turned.x.store(results.x);
  turned.y.store(results.y);
  turned.z.store(results.z);
  return results;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test
