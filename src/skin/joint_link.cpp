/// Eight links at a time. A group of fewer repeats the last link, and writes it repeatedly.

#include "skin/joint_link.hpp"

#include "geometry/points8.hpp"
#include "skin/dual_skin.hpp"

#include <algorithm>
#include <cstddef>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// The numbers of eight links.
using LinkGroup = std::size_t[8];

/// Reads four floats of each of eight links.
template <typename RowAt>
Rows8 rows_of(const RowAt& row) {
  return rows8(row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7));
}

/// The low and the high halves of eight floats of each of eight links.
struct Halves {
  Points8 low, high;
};

Points8 vectors_of(const Rows8& rows) { return {rows.x, rows.y, rows.z}; }

/// Inlined, because its result has six registers.
template <typename RowAt>
[[gnu::always_inline]] inline Halves halves_of(const RowAt& row) {
  const Float8 rows[] = {row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7)};
  return {vectors_of(rows_of([&](int i) { return rows[i].low(); })),
          vectors_of(rows_of([&](int i) { return rows[i].high(); }))};
}

Points8 abs(const Points8& p) { return {abs(p.x), abs(p.y), abs(p.z)}; }
Points8 max(const Points8& p, const Points8& q) {
  return {max(p.x, q.x), max(p.y, q.y), max(p.z, q.z)};
}

Points8 all(float coordinate) {
  return {Float8(coordinate), Float8(coordinate), Float8(coordinate)};
}

/// Bounds of the magnitudes of cross products of vectors with these magnitudes.
Points8 cross_magnitudes(const Points8& p, const Points8& q) {
  return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

/// The vector parts of a b*.
Points8 turns_between(const Rows8& a, const Rows8& b) {
  return b.w * vectors_of(a) - a.w * vectors_of(b) - cross(vectors_of(a), vectors_of(b));
}

/// Eight motions, one in each lane; see LinkMotion.
struct Motions8 {
  Points8 down, up, swell, turn;
  Float8 squared, magnitude, cosine;
};

/// Computes the motions of eight links.
class Links8 {
 public:
  Links8(const JointLink* links, const LinkGroup& group, const MovedJoints& joints)
      : links_(links), group_(group), joints_(joints) {}

  Motions8 motions(float growth, float slack) const {
    const auto rotation = [&](std::uint16_t joint) { return load4(joints_.duals[joint].real); };
    const Rows8 a = rows_of([&](int i) { return rotation(links_[group_[i]].first); });
    const Rows8 b = rows_of([&](int i) { return rotation(links_[group_[i]].second); });
    Motions8 m;
    // The dot product of the definition, so that its sign is the same.
    m.cosine = (a.x * b.x + a.z * b.z) + (a.y * b.y + a.w * b.w);
    m.magnitude = pelt::detail::abs(m.cosine);
    m.squared = Float8(2.0f) * (Float8(1.0f) - m.magnitude) + Float8(kCosineRounding);
    const Float8 sign = select(m.cosine < Float8(0.0f), Float8(-1.0f), Float8(1.0f));
    m.turn = sign * turns_between(a, b);

    const auto [x, y] = columns_from(0);
    const auto [z, t] = columns_from(8);
    const auto [centre, half] = halves_of([&](int i) { return load8(links_[group_[i]].centre); });
    const Points8 grown = half + all(growth), rounding = all(slack);
    const Points8 way = (centre.x * x + centre.y * y) + (centre.z * z + t);
    const Points8 reach = grown.x * abs(x) + grown.y * abs(y) + grown.z * abs(z);
    const Points8 middle = cross(way, m.turn);
    const Points8 around = cross_magnitudes(reach, abs(m.turn)) + rounding;
    m.down = around - middle, m.up = around + middle;
    m.swell = sqrt(m.squared) * (abs(way) + reach + rounding);
    return m;
  }

 private:
  /// Two columns of the differences of the matrices of both joints.
  [[gnu::always_inline]] Halves columns_from(std::size_t element) const {
    return halves_of([&](int i) {
      const JointLink& link = links_[group_[i]];
      return load8(&joints_.matrices[link.first].m[element]) -
             load8(&joints_.matrices[link.second].m[element]);
    });
  }

  const JointLink* links_;
  const LinkGroup& group_;
  const MovedJoints& joints_;
};

void store(const Motions8& m, const LinkGroup& group, LinkMotion* out) {
  Float4 down[8], up[8], swell[8], turn[8];
  vectors_of({m.down.x, m.down.y, m.down.z, Float8(0.0f)}, down);
  vectors_of({m.up.x, m.up.y, m.up.z, m.squared}, up);
  vectors_of({m.swell.x, m.swell.y, m.swell.z, m.magnitude}, swell);
  vectors_of({m.turn.x, m.turn.y, m.turn.z, m.cosine}, turn);
  for (std::size_t i = 0; i < 8; ++i) {
    LinkMotion& motion = out[group[i]];
    store4(motion.down_up, down[i]), store4(motion.down_up + 4, up[i]);
    store4(motion.swell, swell[i]), store4(motion.turn, turn[i]);
  }
}

/// The hulls of the links of each lane.
class Hulls8 {
 public:
  void include(const Motions8& m) {
    down_ = max(down_, m.down), up_ = max(up_, m.up), swell_ = max(swell_, m.swell);
    squared_ = pelt::detail::max(squared_, m.squared);
    cosine_ = pelt::detail::min(cosine_, m.cosine);
  }

  LinkHull united() const {
    LinkHull hull;
    store4(hull.down_up, largest(down_, Float8(0.0f)));
    store4(hull.down_up + 4, largest(up_, squared_));
    store4(hull.swell, largest(swell_, Float8(0.0f)));
    for (unsigned lane = 0; lane < 8; ++lane)
      hull.least_cosine = std::min(hull.least_cosine, lane_of(cosine_, lane));
    return hull;
  }

 private:
  static Float4 largest(const Points8& p, const Float8& w) {
    Float4 vectors[8], most(0.0f);
    vectors_of({p.x, p.y, p.z, w}, vectors);
    for (const Float4& vector : vectors) most = pelt::detail::max(most, vector);
    return most;
  }

  Points8 down_ = all(0), up_ = all(0), swell_ = all(0);
  Float8 squared_{0.0f}, cosine_{1.0f};
};

}  // namespace

LinkHull move_links(std::span<const JointLink> links, const MovedJoints& joints, float growth,
                    float slack, LinkMotion* out) {
  Hulls8 hulls;
  for (std::size_t first = 0; first < links.size(); first += 8) {
    LinkGroup group;
    for (std::size_t i = 0; i < 8; ++i) group[i] = std::min(first + i, links.size() - 1);
    const Motions8 motions = Links8(links.data(), group, joints).motions(growth, slack);
    store(motions, group, out);
    hulls.include(motions);
  }
  return hulls.united();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
