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

/// Up to eight fans of one size.
struct FanBatch {
  std::uint32_t numbers[kBatch];
  std::uint32_t count = 0;
};

/// Collects fans without slack from number `fan` on, and moves `fan` past them.
FanBatch next_batch(const Fans& fans, const float* slack, std::uint32_t end, std::uint32_t& fan) {
  const std::uint32_t* begin = fans.begin.data();
  const auto size = [&](std::uint32_t f) { return begin[f + 1] - begin[f]; };
  FanBatch batch;
  for (; fan < end && batch.count < kBatch; ++fan) {
    if (slack && slack[fan] > 0) continue;
    if (batch.count > 0 && size(fan) != size(batch.numbers[0])) break;
    batch.numbers[batch.count++] = fan;
  }
  return batch;
}

void keep_slack(const FanBatch& batch, const FlatFans& flat, float* slack) {
  float lanes[kBatch];
  flat.slack.store(lanes);
  for (std::uint32_t i = 0; i < batch.count; ++i)
    slack[batch.numbers[i]] = flat.certified >> i & 1 ? lanes[i] : 0;
}

/// Finds the pairs of the fans of a kind that can be certified. Returns false if the answer is
/// full.
bool test_flat(const Fans& fans, FanKind kind, Positions positions, float* slack, FanPairs& pairs,
               const SelfAnswer& answer) {
  const std::uint32_t end = fans.kind_begin[static_cast<std::size_t>(kind) + 1];
  for (std::uint32_t fan = fans.kind_begin[static_cast<std::size_t>(kind)]; fan < end;) {
    const FanBatch batch = next_batch(fans, slack, end, fan);
    if (batch.count == 0) break;
    const FlatFans flat = test_flat_fans(fans, kind, batch.numbers, batch.count, positions);
    if (slack) keep_slack(batch, flat, slack);
    for (SetBits lane(~flat.certified & ((1u << batch.count) - 1)); lane; ++lane) {
      pairs.test(batch.numbers[*lane], false);
      if (answer.is_full()) return false;
    }
  }
  return true;
}

}  // namespace

bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, float* slack,
               SelfAnswer& answer, QueryStats& work) {
  FanPairs pairs(posed, fans, positions, answer, work);
  for (const FanKind kind : {FanKind::closed, FanKind::open})
    if (!test_flat(fans, kind, positions, slack, pairs, answer)) return true;
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
