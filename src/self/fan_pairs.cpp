#include "self/fan_pairs.hpp"

#include "geometry/neighbour_pair.hpp"
#include "query/find_triangle.hpp"
#include "query/lanes.hpp"
#include "query/triangle_batch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the pairs of triangles of single fans.
class FanPairs {
 public:
  FanPairs(const PosedTree& posed, const Fans& fans, Positions positions, SelfAnswer& answer,
           QueryStats& work)
      : ids_(posed.tree.triangle_ids.data()),
        fans_(fans),
        positions_(positions),
        reader_(posed),
        answer_(answer),
        work_(work) {}

  /// `is_cracked`: whether vertices of the fan's corners may have different positions.
  void test(std::uint32_t fan, bool is_cracked) {
    const FanTriangle* const begin = fans_.triangles.data() + fans_.begin.data()[fan];
    const FanTriangle* const end = fans_.triangles.data() + fans_.begin.data()[fan + 1];
    const std::uint32_t vertex = fans_.corners.data()[begin->place()][begin->corner()];
    for (const FanTriangle* a = begin; a != end; ++a) {
      const SurfaceTriangle triangle = read(a->place(), is_cracked);
      for (const FanTriangle* b = begin; b != a; ++b) {
        // Triangles that share several vertices are tested once, in the fan of the lowest.
        if (shares_lower(triangle, fans_.corners.data()[b->place()], vertex)) continue;
        ++work_.triangle_pairs;
        if (!surface_triangles_intersect(triangle, read(b->place(), is_cracked))) continue;
        answer_.contacts().push(Contact{ids_[a->place()], ids_[b->place()]});
        answer_.settle();
        if (answer_.is_full()) return;
      }
    }
  }

 private:
  SurfaceTriangle read(std::uint32_t place, bool is_cracked) {
    const std::array<std::uint32_t, 3>& vertices = fans_.corners.data()[place];
    if (is_cracked) return {reader_.corners(ids_[place], work_), vertices};
    return {corners_at([&](std::size_t k) { return positions_[vertices[k]].data(); }), vertices};
  }

  static bool shares_lower(const SurfaceTriangle& a, const std::array<std::uint32_t, 3>& b,
                           std::uint32_t vertex) {
    for (const std::uint32_t v : a.vertices)
      if (v < vertex && (v == b[0] || v == b[1] || v == b[2])) return true;
    return false;
  }

  const std::uint32_t* ids_;
  const Fans& fans_;
  Positions positions_;
  TriangleReader reader_;
  SelfAnswer& answer_;
  QueryStats& work_;
};

/// Returns the number of fans from `first` on, at most eight, that have the same size.
std::uint32_t fans_of_one_size(const Fans& fans, std::uint32_t first, std::uint32_t end) {
  const std::uint32_t* begin = fans.begin.data();
  const auto size = [&](std::uint32_t fan) { return begin[fan + 1] - begin[fan]; };
  std::uint32_t count = 1;
  while (count < kBatch && first + count < end && size(first + count) == size(first)) ++count;
  return count;
}

}  // namespace

bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, SelfAnswer& answer,
               QueryStats& work) {
  FanPairs pairs(posed, fans, positions, answer, work);
  for (const FanKind kind : {FanKind::closed, FanKind::open}) {
    const std::uint32_t end = fans.kind_begin[static_cast<std::size_t>(kind) + 1];
    for (std::uint32_t fan = fans.kind_begin[static_cast<std::size_t>(kind)]; fan < end;) {
      const std::uint32_t count = fans_of_one_size(fans, fan, end);
      const unsigned flat = flat_fans(fans, kind, fan, count, positions);
      for (SetBits lane(~flat & ((1u << count) - 1)); lane; ++lane) {
        pairs.test(fan + *lane, false);
        if (answer.is_full()) return true;
      }
      fan += count;
    }
  }
  for (const FanKind kind : {FanKind::complex, FanKind::cracked})
    for (std::uint32_t fan = fans.kind_begin[static_cast<std::size_t>(kind)];
         fan < fans.kind_begin[static_cast<std::size_t>(kind) + 1]; ++fan) {
      pairs.test(fan, kind == FanKind::cracked);
      if (answer.is_full()) return true;
    }
  return false;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
