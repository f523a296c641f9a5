#include "self/fan_pairs.hpp"

#include "query/find_triangle.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"
#include "self/neighbour_pair.hpp"

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

  /// Tests all pairs of triangles of a fan.
  void test_all(const FanRun& run, std::uint32_t fan) {
    begin(run, fan);
    for (std::uint32_t k = 1; k < run.size; ++k)
      for (std::uint32_t i = 0; i < k && !answer_.is_full(); ++i) test(i, k);
  }

  /// Tests the listed pairs: bit i of row k for the triangles i and k.
  void test_listed(const FanRun& run, std::uint32_t fan, const std::uint32_t* rows) {
    begin(run, fan);
    for (std::uint32_t k = 1; k < run.size; ++k)
      for (SetBits i(rows[k]); i && !answer_.is_full(); ++i) test(*i, k);
  }

 private:
  void begin(const FanRun& run, std::uint32_t fan) {
    triangles_ = fans_.triangles.data() + run.triangle_of(fan);
    vertex_ = fans_.corners.data()[triangles_->place()][triangles_->corner()];
    is_cracked_ = run.kind == FanKind::cracked;
  }

  /// Triangles that share several vertices are tested once, in the fan of the lowest.
  void test(std::uint32_t i, std::uint32_t k) {
    const std::uint32_t a = triangles_[k].place(), b = triangles_[i].place();
    if (share_lower(fans_.corners.data()[a], fans_.corners.data()[b])) return;
    ++work_.triangle_pairs;
    if (!surface_triangles_intersect(read(a), read(b))) return;
    answer_.contacts().push(Contact{ids_[a], ids_[b]});
    answer_.settle();
  }

  SurfaceTriangle read(std::uint32_t place) {
    const SurfaceCorners& vertices = fans_.corners.data()[place];
    if (is_cracked_) return {reader_.corners(ids_[place], work_), vertices};
    return {corners_at([&](std::size_t k) { return positions_[vertices[k]].data(); }), vertices};
  }

  bool share_lower(const SurfaceCorners& a, const SurfaceCorners& b) const {
    for (const std::uint32_t v : a)
      if (v < vertex_ && has_corner(b, v)) return true;
    return false;
  }

  const std::uint32_t* ids_;
  const Fans& fans_;
  Positions positions_;
  TriangleReader reader_;
  SelfAnswer& answer_;
  QueryStats& work_;

  // The fan that is tested.
  const FanTriangle* triangles_ = nullptr;
  std::uint32_t vertex_ = 0;
  bool is_cracked_ = false;  // vertices of the fan's corners may have different positions
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
    UndecidedPairs undecided;
    const FlatFans flat =
        test_flat_fans(fans, run, batch.numbers, batch.count, positions, undecided);
    if (slack) keep_slack(batch, flat, slack);
    for (SetBits lane(~flat.certified & ((1u << batch.count) - 1)); lane; ++lane) {
      pairs.test_listed(run, batch.numbers[*lane], undecided.rows[*lane]);
      if (answer.is_full()) return false;
    }
  }
  return true;
}

/// The same for fans that cannot be certified.
bool test_pairs(const FanRun& run, FanPairs& pairs, const SelfAnswer& answer) {
  for (std::uint32_t fan = run.first_fan; fan < run.end; ++fan) {
    pairs.test_all(run, fan);
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
