/// A fan has a vertex v and triangles (v, p_i, p_i+1). Let e_i = p_i - v be its spokes, and n any
/// vector. Project everything along n onto a plane. Seen against n, spoke e_i+1 is to the left of
/// spoke e_i if det(n, e_i, e_i+1) > 0. If this holds for all triangles, they become wedges of less
/// than a half turn, which follow each other counter-clockwise.
///
/// The wedges do not overlap if they make at most one turn in all. A wedge of less than a half turn
/// is the intersection of two half-planes: it contains e_0 if and only if e_i is not to the left of
/// e_0 and e_i+1 is not to the right. If no wedge contains e_0 except the first, which begins
/// there, and in a closed fan the last, which ends there, then the wedges make one turn, or less.
///
/// Two triangles of such a fan meet only where they should. Let x be a common point. Its projection
/// is in both wedges. If the triangles have no spoke in common, the wedges share only the
/// projection of v, so x is on the line through v along n. A triangle that projects onto a wedge
/// contains only one point of each such line; therefore x = v. In the same way, if they share a
/// spoke, x is on the shared edge.
///
/// Rounding. n is any float vector, so only the spokes and the determinants are rounded. Let e =
/// 2^-24, and X, Y, Z the largest |x|, |y|, |z| of all spokes. A determinant is a sum of six
/// products; each has at most 7 relative errors e: two spokes, two multiplications, one difference,
/// two sums. Its error is at most 2 * 7.1 e B < 15 e B, with B = |n.x| Y Z + |n.y| X Z + |n.z| X Y;
/// 32 e B = 2^-19 B covers this and the rounding of B. n is scaled to a largest coordinate of 1. A
/// product that underflows therefore adds at most 2^-150 times 1, or times the largest coordinate L
/// of a spoke; 2^-140 (1 + L) covers all of them. Nothing overflows, because spokes are below
/// 2^61.1. If n is zero, no comparison holds, and the fan is not certified.
///
/// Single pairs. Two triangles also meet only where they should if the spokes of one that the other
/// does not share are strictly on one side of the other's plane: one triangle then meets the plane
/// only in what they share (neighbours.cpp). Triangle i has the normal e_i x e_i+1, so the side
/// of spoke k is the sign of det(e_i, e_i+1, e_k). Here, all three vectors are rounded: its error
/// is at most 6 * 8.1 e X Y Z < 64 e X Y Z. 2^-140 (1 + L) covers underflow, as above. The factor
/// 64 makes the bound infinite or NaN before a sum of six products overflows.
#include "self/flat_fans.hpp"

#include "geometry/points8.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"

#include <algorithm>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

Float8 max3(const Points8& p) { return max(max(p.x, p.y), p.z); }
Points8 abs(const Points8& p) { return {abs(p.x), abs(p.y), abs(p.z)}; }
Points8 max(const Points8& p, const Points8& q) {
  return {max(p.x, q.x), max(p.y, q.y), max(p.z, q.z)};
}

/// The spokes of eight fans with the same number of triangles.
class Spokes {
 public:
  Spokes(const Fans& fans, const FanRun& run, const std::uint32_t* numbers, std::uint32_t count,
         Positions positions)
      : corners_(fans.corners.data()->data()),
        positions_(positions),
        size_(run.size),
        lane_count_(count),
        is_closed_(run.kind == FanKind::closed) {
    for (std::uint32_t lane = 0; lane < kBatch; ++lane)
      triangles_[lane] = fans.triangles.data() + run.triangle_of(numbers[lane < count ? lane : 0]);
    const Points8 centre = corners(0, 0);
    for (std::uint32_t i = 0; i < size_; ++i) spokes_[i] = corners_after(i) - centre;
    spokes_[size_] = is_closed_ ? spokes_[0] : corners(size_ - 1, 2) - centre;
    for (std::uint32_t i = 0; i < size_; ++i) areas_[i] = cross(spokes_[i], spokes_[i + 1]);
  }

  FlatFans test(UndecidedPairs& undecided) const {
    const Points8 normal = common_normal();
    const Points8 longest = largest_coordinates();
    const Float8 error = error_of(normal, longest);
    Float8 least = dot(normal, areas_[0]) - error;
    Mask8 certified = Float8(0.0f) < least;
    const auto demand = [&](const Float8& excess) {
      certified = certified & (Float8(0.0f) < excess);
      least = min(least, excess);
    };
    for (std::uint32_t i = 1; i < size_; ++i) demand(dot(normal, areas_[i]) - error);
    // The wedge i contains the first spoke unless `left` is true of i, or `right` of i + 1.
    const Points8 across = cross(normal, spokes_[0]);
    const std::uint32_t wedge_count = is_closed_ ? size_ - 1 : size_;
    Float8 left = dot(across, spokes_[1]);
    for (std::uint32_t i = 1; i < wedge_count; ++i) {
      const Float8 right = dot(across, spokes_[i + 1]);
      demand(max(left, Float8(0.0f) - right) - error);
      left = right;
    }
    const unsigned all = (1u << lane_count_) - 1, flat = certified.bits() & all;
    if (flat != all) write_undecided(all & ~flat, longest, undecided);
    return {flat, least, dot(longest, longest)};
  }

 private:
  /// The fans in which a spoke is certainly in front of a triangle's plane, or behind it.
  struct Sides {
    std::uint8_t front[kMaxFan + 1], behind[kMaxFan + 1];

    unsigned either(std::uint32_t spoke) const { return front[spoke] | behind[spoke]; }
    unsigned same(std::uint32_t k, std::uint32_t m) const {
      return (front[k] & front[m]) | (behind[k] & behind[m]);
    }
  };

  void write_undecided(unsigned fans, const Points8& longest, UndecidedPairs& undecided) const {
    Sides sides[kMaxFan];
    for (std::uint32_t i = 0; i < size_; ++i) find_sides(areas_[i], longest, sides[i]);
    for (SetBits fan(fans); fan; ++fan) std::fill_n(undecided.rows[*fan], size_, 0);
    for (std::uint32_t k = 1; k < size_; ++k)
      for (std::uint32_t i = 0; i < k; ++i) {
        const unsigned apart = beside(sides[i], i, k) | beside(sides[k], k, i);
        for (SetBits fan(fans & ~apart); fan; ++fan) undecided.rows[*fan][k] |= 1u << i;
      }
  }

  void find_sides(const Points8& area, const Points8& longest, Sides& sides) const {
    const Float8 error = Float8(64.0f) * longest.x * longest.y * longest.z * Float8(0x1p-24f) +
                         Float8(0x1p-140f) * (Float8(1.0f) + max3(longest));
    for (std::uint32_t k = 0; k <= size_; ++k) {
      const Float8 volume = dot(area, spokes_[k]);
      sides.front[k] = static_cast<std::uint8_t>((error < volume).bits());
      sides.behind[k] = static_cast<std::uint8_t>((volume < Float8(0.0f) - error).bits());
    }
  }

  /// The fans in which triangle `other` touches the plane of triangle `i` only in what they share.
  unsigned beside(const Sides& sides, std::uint32_t i, std::uint32_t other) const {
    if (is_next(i, other)) return sides.either(other + 1);
    if (is_next(other, i)) return sides.either(other);
    return sides.same(other, other + 1);
  }

  bool is_next(std::uint32_t i, std::uint32_t next) const {
    return i + 1 == next || (is_closed_ && next == 0 && i + 1 == size_);
  }

  /// Triangle i's corner that comes `step` after the fan's vertex.
  Points8 corners(std::uint32_t i, std::uint32_t step) const {
    return gather_points([&](std::uint32_t lane) {
      const FanTriangle& t = triangles_[lane][i];
      return positions_[corners_[3 * t.place() + (t.corner() + step) % 3]].data();
    });
  }

  /// The same with step 1.
  [[gnu::always_inline]] Points8 corners_after(std::uint32_t i) const {
    return gather_points([&](std::uint32_t lane) {
      return positions_[corners_[triangles_[lane][i].after()]].data();
    });
  }

  /// The direction of the sum of the triangles' area vectors, with a largest coordinate of 1.
  Points8 common_normal() const {
    Points8 sum = areas_[0];
    for (std::uint32_t i = 1; i < size_; ++i) sum = sum + areas_[i];
    return Float8(1.0f) / max3(abs(sum)) * sum;
  }

  Points8 largest_coordinates() const {
    Points8 largest = abs(spokes_[0]);
    for (std::uint32_t i = 1; i <= size_; ++i) largest = max(largest, abs(spokes_[i]));
    return largest;
  }

  static Float8 error_of(const Points8& normal, const Points8& longest) {
    const Points8 n = abs(normal);
    const Float8 bound =
        n.x * longest.y * longest.z + n.y * longest.x * longest.z + n.z * longest.x * longest.y;
    return Float8(0x1p-19f) * bound + Float8(0x1p-140f) * (Float8(1.0f) + max3(longest));
  }

  const FanTriangle* triangles_[kBatch];
  const std::uint32_t* corners_;  // of all triangles, one after the other
  Positions positions_;
  std::uint32_t size_, lane_count_;
  bool is_closed_;
  Points8 spokes_[kMaxFan + 1];
  Points8 areas_[kMaxFan];  // normals of the triangles, twice their areas long
};

}  // namespace

/// (sqrt(L^2 + d) - L) / 2 = d / (2 (sqrt(L^2 + d) + L)), see self_track.hpp. `least` is at most
/// the least determinant, and |n| <= 1.7321 < 1 / 0.577, so d <= least / |n|. 0.4999 is 2^-12 below
/// 1/2, which covers the roundings of spokes, squares and roots. Where L^2 underflows, the error
/// that was subtracted from `least` was larger.
Float8 FlatFans::slack() const {
  const Float8 d = least * Float8(0.577f);
  const Float8 length = sqrt(squared_length), sum = sqrt(squared_length + d) + length;
  return Float8(0.4999f) * (d / sum);
}

FlatFans test_flat_fans(const Fans& fans, const FanRun& run, const std::uint32_t* numbers,
                        std::uint32_t count, Positions positions, UndecidedPairs& undecided) {
  return Spokes(fans, run, numbers, count, positions).test(undecided);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
