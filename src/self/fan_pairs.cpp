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

  void test(const FanRun& run, std::uint32_t fan) {
    const bool is_cracked = run.kind == FanKind::cracked;
    const FanTriangle* const begin = fans_.triangles.data() + run.triangle_of(fan);
    const FanTriangle* const end = begin + run.size;
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
  /// `is_cracked`: whether vertices of the fan's corners may have different positions.
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

/// Up to eight fans of a run.
struct FanBatch {
  std::uint32_t numbers[kBatch];
  std::uint32_t count = 0;
};

/// Collects fans without slack from number `fan` on, and moves `fan` past them.
FanBatch next_batch(const FanRun& run, const float* slack, std::uint32_t& fan) {
  FanBatch batch;
  for (; fan < run.end && batch.count < kBatch; ++fan)
    if (!(slack && slack[fan] > 0)) batch.numbers[batch.count++] = fan;
  return batch;
}

void keep_slack(const FanBatch& batch, const FlatFans& flat, float* slack) {
  float lanes[kBatch];
  flat.slack().store(lanes);
  for (std::uint32_t i = 0; i < batch.count; ++i)
    slack[batch.numbers[i]] = flat.certified >> i & 1 ? lanes[i] : 0;
}

/// Finds the pairs of a run of fans that can be certified. Returns false if the answer is full.
bool test_flat(const Fans& fans, const FanRun& run, Positions positions, float* slack,
               FanPairs& pairs, const SelfAnswer& answer) {
  for (std::uint32_t fan = run.first_fan; fan < run.end;) {
    const FanBatch batch = next_batch(run, slack, fan);
    if (batch.count == 0) break;
    const FlatFans flat = test_flat_fans(fans, run, batch.numbers, batch.count, positions);
    if (slack) keep_slack(batch, flat, slack);
    for (SetBits lane(~flat.certified & ((1u << batch.count) - 1)); lane; ++lane) {
      pairs.test(run, batch.numbers[*lane]);
      if (answer.is_full()) return false;
    }
  }
  return true;
}

/// The same for fans that cannot be certified.
bool test_pairs(const FanRun& run, FanPairs& pairs, const SelfAnswer& answer) {
  for (std::uint32_t fan = run.first_fan; fan < run.end; ++fan) {
    pairs.test(run, fan);
    if (answer.is_full()) return false;
  }
  return true;
}

}  // namespace

bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, float* slack,
               SelfAnswer& answer, QueryStats& work) {
  FanPairs pairs(posed, fans, positions, answer, work);
  for (const FanRun& run : fans.runs)
    if (!(can_be_flat(run.kind) ? test_flat(fans, run, positions, slack, pairs, answer)
                                : test_pairs(run, pairs, answer)))
      return true;
  return false;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
