#include "asset/channel.hpp"

#include "asset/quaternion.hpp"
#include "base/assert.hpp"

#include <algorithm>

namespace pelt::asset {
namespace {

using Value = std::array<double, 4>;

enum KeyPart { in_tangent, value, out_tangent };

Value key_part(const Channel& channel, std::size_t key, KeyPart part) {
  const std::size_t size = value_size(channel.path);
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  const std::size_t first = size * (cubic ? 3 * key + part : key);
  Value result = {};
  for (std::size_t i = 0; i < size; ++i) result[i] = channel.values[first + i];
  return result;
}

Quaternion quaternion(const Value& v) { return {v[0], v[1], v[2], v[3]}; }
Value numbers(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }

Value linear(const Channel& channel, std::size_t key, double t) {
  const Value a = key_part(channel, key, value);
  const Value b = key_part(channel, key + 1, value);
  if (channel.path == Path::rotation) return numbers(slerp(quaternion(a), quaternion(b), t));
  Value result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = a[i] * (1 - t) + b[i] * t;
  return result;
}

Value cubic_spline(const Channel& channel, std::size_t key, double t, double interval) {
  const Value a = key_part(channel, key, value);
  const Value leaving_a = key_part(channel, key, out_tangent);
  const Value entering_b = key_part(channel, key + 1, in_tangent);
  const Value b = key_part(channel, key + 1, value);
  const double t2 = t * t, t3 = t2 * t;
  Value result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double values = (2 * t3 - 3 * t2 + 1) * a[i] + (3 * t2 - 2 * t3) * b[i];
    const double tangents = (t3 - 2 * t2 + t) * leaving_a[i] + (t3 - t2) * entering_b[i];
    result[i] = values + interval * tangents;
  }
  if (channel.path == Path::rotation) return numbers(normalised(quaternion(result)));
  return result;
}

}  // namespace

std::array<double, 4> sample_channel(const Channel& channel, float seconds) {
  const auto& times = channel.times;
  PELT_ASSERT(!times.empty());
  if (!(seconds > times.front())) return key_part(channel, 0, value);
  if (seconds >= times.back()) return key_part(channel, times.size() - 1, value);

  const auto next = std::upper_bound(times.begin(), times.end(), seconds);
  const std::size_t key = static_cast<std::size_t>(next - times.begin()) - 1;
  const double interval = double{times[key + 1]} - double{times[key]};
  const double t = (double{seconds} - double{times[key]}) / interval;
  switch (channel.interpolation) {
    case Interpolation::step:
      return key_part(channel, key, value);
    case Interpolation::linear:
      return linear(channel, key, t);
    case Interpolation::cubic_spline:
      return cubic_spline(channel, key, t, interval);
  }
  PELT_ASSERT(false);
  return {};
}

}  // namespace pelt::asset
