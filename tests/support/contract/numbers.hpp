#pragma once

/// Answers as lists of numbers. Floats and 32-bit integers are exact in double.

#include <pelt/crowd.hpp>
#include <pelt/pelt.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace pelt::contract {

/// The bits of each number as a double, so that NaN equals NaN, and -0.0 differs from 0.0.
using Numbers = std::vector<std::uint64_t>;

template <typename Number>
requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void put(Numbers& numbers,
                                                                          const Number& number) {
  numbers.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(number)));
}

inline void put(Numbers& n, const Vec3& v) { put(n, v.x), put(n, v.y), put(n, v.z); }
inline void put(Numbers& n, const Box& box) { put(n, box.low), put(n, box.high); }
inline void put(Numbers& n, const Contact& c) { put(n, c.triangle_a), put(n, c.triangle_b); }

inline void put(Numbers& n, const Feature& f) { put(n, f.kind), put(n, f.number); }
inline void put(Numbers& n, const MovingContact& c) {
  put(n, c.contact), put(n, c.time), put(n, c.at_start), put(n, c.a), put(n, c.b);
}
inline void put(Numbers& n, const RegionEntry& e) {
  put(n, e.triangle), put(n, e.time), put(n, e.at_start);
}

inline void put(Numbers& n, const CrowdPair& p) { put(n, p.instance_a), put(n, p.instance_b); }
inline void put(Numbers& n, const CrowdContact& c) {
  put(n, c.instance_a), put(n, c.instance_b), put(n, c.triangle_a), put(n, c.triangle_b);
}
inline void put(Numbers& n, const CrowdMovingContact& c) {
  put(n, c.instance_a), put(n, c.instance_b), put(n, c.moving);
}

inline void put(Numbers& n, const SurfacePoint& p) {
  put(n, p.triangle), put(n, p.position);
  for (const float weight : p.barycentrics) put(n, weight);
}
inline void put(Numbers& n, const ClosestPoint& c) { put(n, c.distance), put(n, c.point); }
inline void put(Numbers& n, const Distance& d) {
  put(n, d.distance), put(n, d.lower_bound), put(n, d.a), put(n, d.b);
}
inline void put(Numbers& n, const SolidDistance& d) {
  put(n, d.distance), put(n, d.surface), put(n, d.solid);
}

inline void put(Numbers& n, const Bounds& b) {
  put(n, b.box), put(n, b.sphere.centre), put(n, b.sphere.radius);
}
inline void put(Numbers& n, const RayHit& hit) {
  put(n, hit.triangle), put(n, hit.t), put(n, hit.normal);
  for (const float weight : hit.barycentrics) put(n, weight);
}
inline void put(Numbers& n, const FarthestVertex& v) {
  put(n, v.triangle), put(n, v.corner), put(n, v.position);
}
inline void put(Numbers& n, const Penetration& p) {
  put(n, p.vertex), put(n, p.depth), put(n, p.position), put(n, p.closest);
}
inline void put(Numbers& n, const Volume& v) { put(n, v.value), put(n, v.error); }

inline void put(Numbers& n, const ContactTrace& t) {
  put(n, t.contact), put(n, t.kind), put(n, t.from), put(n, t.to), put(n, t.normal);
  put(n, t.depth);
}
inline void put(Numbers& n, const CurveStep& s) { put(n, s.trace), put(n, s.is_reversed); }
inline void put(Numbers& n, const ContactCurve& c) {
  put(n, c.first), put(n, c.count), put(n, c.is_closed), put(n, c.length), put(n, c.area);
}
inline void put(Numbers& n, const ContactPatch& p) {
  put(n, p.first), put(n, p.count), put(n, p.length), put(n, p.depth);
  put(n, p.joint_a), put(n, p.joint_b);
}

template <typename Item>
void put(Numbers& n, const std::optional<Item>& item) {
  put(n, item.has_value());
  if (item) put(n, *item);
}
template <typename Item>
void put(Numbers& n, const std::vector<Item>& items) {
  put(n, items.size());
  for (const Item& item : items) put(n, item);
}
template <typename Item, std::size_t kCount>
void put(Numbers& n, const std::array<Item, kCount>& items) {
  for (const Item& item : items) put(n, item);
}

inline void put(Numbers& n, const TrianglesInRegion& t) {
  put(n, t.intersecting), put(n, t.inside);
}
inline void put(Numbers& n, const ContactGeometry& g) {
  put(n, g.traces), put(n, g.steps), put(n, g.curves), put(n, g.members), put(n, g.patches);
}

template <typename Answer>
Numbers numbers_of(const Answer& answer) {
  Numbers numbers;
  put(numbers, answer);
  return numbers;
}

/// The numbers of an answer, to be printed.
template <typename Answer>
std::vector<double> readable(const Answer& answer) {
  std::vector<double> numbers;
  for (const std::uint64_t bits : numbers_of(answer))
    numbers.push_back(std::bit_cast<double>(bits));
  return numbers;
}

}  // namespace pelt::contract
