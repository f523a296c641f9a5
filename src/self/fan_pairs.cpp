#include "self/fan_pairs.hpp"

#include "geometry/points8.hpp"
#include "query/find_triangle.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"
#include "self/neighbour_separation.hpp"
#include "self/neighbours.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// The triangles of a fan, by place. Triangles that share several vertices are tested once, in the
/// fan of the lowest.
class FanTriangles {
 public:
  FanTriangles(const Fans& fans, const FanRun& run, std::uint32_t fan)
      : corners_(fans.corners.data()),
        triangles_(fans.triangles.data() + run.triangle_of(fan)),
        count_(run.size),
        vertex_(corners_[triangles_->place()][triangles_->corner()]) {}

  /// Calls `test(a, b)` with the places of the triangles k and i, unless another fan does.
  template <typename Test>
  void visit(std::uint32_t i, std::uint32_t k, const Test& test) const {
    const std::uint32_t a = triangles_[k].place(), b = triangles_[i].place();
    if (!share_lower(corners_[a], corners_[b])) test(a, b);
  }

  /// Visits all pairs until the sink is full.
  template <typename Sink, typename Test>
  void visit_all(const Sink& sink, const Test& test) const {
    for (std::uint32_t k = 1; k < count_; ++k)
      for (std::uint32_t i = 0; i < k && !sink.is_full(); ++i) visit(i, k, test);
  }

  /// Visits the listed pairs until the sink is full: bit i of row k for the triangles i and k.
  template <typename Sink, typename Test>
  void visit_listed(const std::uint32_t* rows, const Sink& sink, const Test& test) const {
    for (std::uint32_t k = 1; k < count_; ++k)
      for (SetBits i(rows[k]); i && !sink.is_full(); ++i) visit(*i, k, test);
  }

 private:
  bool share_lower(const SurfaceCorners& a, const SurfaceCorners& b) const {
    for (const std::uint32_t v : a)
      if (v < vertex_ && has_corner(b, v)) return true;
    return false;
  }

  const SurfaceCorners* corners_;
  const FanTriangle* triangles_;
  std::uint32_t count_, vertex_;
};

/// Tests all pairs of triangles of a run of fans. Returns false if the sink is full.
template <typename Pairs, typename Sink>
bool test_run(const FanRun& run, Pairs& pairs, const Sink& sink) {
  for (std::uint32_t fan = run.first_fan; fan < run.end; ++fan) {
    pairs.test_all(run, fan);
    if (sink.is_full()) return false;
  }
  return true;
}

// Fans in a pose.

/// Tests the pairs of triangles of single fans.
class FanPairs {
 public:
  FanPairs(const PosedTree& posed, const Fans& fans, Positions positions,
           FilteredSink<Contact>& sink, QueryStats& work)
      : ids_(posed.tree.triangle_ids.data()),
        fans_(fans),
        positions_(positions),
        reader_(posed),
        sink_(sink),
        work_(work) {}

  /// Tests all pairs of triangles of a fan.
  void test_all(const FanRun& run, std::uint32_t fan) {
    const bool is_cracked = run.kind == FanKind::cracked;
    FanTriangles(fans_, run, fan).visit_all(sink_, [&](std::uint32_t a, std::uint32_t b) {
      test(a, b, is_cracked);
    });
  }

  /// Tests the listed pairs.
  void test_listed(const FanRun& run, std::uint32_t fan, const std::uint32_t* rows) {
    FanTriangles(fans_, run, fan).visit_listed(rows, sink_, [&](std::uint32_t a, std::uint32_t b) {
      test(a, b, false);
    });
  }

 private:
  /// `is_cracked`: whether vertices of the fan's corners may have different positions.
  void test(std::uint32_t a, std::uint32_t b, bool is_cracked) {
    ++work_.triangle_pairs;
    if (surface_triangles_intersect(read(a, is_cracked), read(b, is_cracked)))
      sink_.push(Contact{ids_[a], ids_[b]});
  }

  SurfaceTriangle read(std::uint32_t place, bool is_cracked) {
    const SurfaceCorners& vertices = fans_.corners.data()[place];
    if (is_cracked) return {reader_.corners(ids_[place], work_), vertices};
    return {corners_at([&](std::size_t k) { return positions_[vertices[k]].data(); }), vertices};
  }

  const std::uint32_t* ids_;
  const Fans& fans_;
  Positions positions_;
  TriangleReader reader_;
  FilteredSink<Contact>& sink_;
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

/// Finds the contacts of those fans of a run that can be certified flat. Returns false if the sink
/// is full.
bool test_flat(const Fans& fans, const FanRun& run, Positions positions, float* slack,
               FanPairs& pairs, const FilteredSink<Contact>& sink) {
  for (std::uint32_t fan = run.first_fan; fan < run.end;) {
    const FanBatch batch = next_batch(run, slack, fan);
    if (batch.count == 0) break;
    UndecidedPairs undecided;
    const FlatFans flat =
        test_flat_fans(fans, run, batch.numbers, batch.count, positions, undecided);
    if (slack) keep_slack(batch, flat, slack);
    for (SetBits lane(~flat.certified & ((1u << batch.count) - 1)); lane; ++lane) {
      pairs.test_listed(run, batch.numbers[*lane], undecided.rows[*lane]);
      if (sink.is_full()) return false;
    }
  }
  return true;
}

// Fans in a step.

/// For NeighbourSeparation, which decides nearly all pairs of a smooth surface.
struct FloatKit {
  using Number = Float8;
  using Point = Points8;
  using Mask = Mask8;

  static Float8 half() { return Float8(0.5f); }
  static Float8 third() { return Float8(1.0f / 3); }
  static Float8 determinant_units() { return Float8(0x1p-24f); }  // 128 e V, of 128 V
  static Float8 projection_units() { return Float8(0x1p-25f); }
  static Float8 tiny() { return Float8(0x1p-80f); }
  static Float8 min(const Float8& x, const Float8& y) { return detail::min(x, y); }
  static Float8 max(const Float8& x, const Float8& y) { return detail::max(x, y); }
  static Float8 largest(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }
};

using FloatSeparation = NeighbourSeparation<FloatKit>;

/// The places of two triangles of a fan, and the vertices of the pair by place: first the shared
/// ones, then the others of a, then those of b.
struct WaitingNeighbours {
  std::uint32_t a, b;
  std::array<std::uint32_t, 5> vertices;
};

/// Tests the pairs of triangles of fans.
class MovingFanPairs {
 public:
  MovingFanPairs(const MovingTree& moving, const Fans& fans, const MovingPositions& positions,
                 const MovingOptions& options, FilteredSink<MovingContact>& sink, MovingStats& work)
      : ids_(moving.tree.triangle_ids.data()),
        fans_(fans),
        positions_(positions),
        from_(moving.from),
        to_(moving.to),
        options_(options),
        sink_(sink),
        work_(work) {}

  /// Adds all pairs of triangles of a fan.
  void test_all(const FanRun& run, std::uint32_t fan) {
    const bool is_simple = can_be_flat(run.kind);
    FanTriangles(fans_, run, fan).visit_all(sink_, [&](std::uint32_t a, std::uint32_t b) {
      ++work_.triangle_pairs;
      is_simple ? add(a, b) : decide(a, b);
    });
  }

  void flush() {
    flush_corner_neighbours();
    flush_edge_neighbours();
  }

 private:
  /// Adds a pair whose surface vertices are at one position each.
  void add(std::uint32_t a, std::uint32_t b) {
    const SurfaceCorners &va = fans_.corners.data()[a], &vb = fans_.corners.data()[b];
    const SharedCorners shared([&](std::size_t i, std::size_t k) { return va[i] == vb[k]; });
    const auto of_a = [&](std::size_t i) { return va[shared.a[i]]; };
    const auto of_b = [&](std::size_t i) { return vb[shared.b[i]]; };
    if (shared.count == 1) {
      at_corner_.add({a, b, {of_a(0), of_a(1), of_a(2), of_b(1), of_b(2)}});
      if (at_corner_.is_full()) flush_corner_neighbours();
    } else if (shared.count == 2) {
      at_edge_.add({a, b, {of_a(0), of_a(1), of_a(2), of_b(2), of_b(2)}});
      if (at_edge_.is_full()) flush_edge_neighbours();
    } else {
      decide(a, b);
    }
  }

  void flush_corner_neighbours() {
    if (at_corner_.count() == 0) return;
    at_corner_.pad();
    const auto seen = [this](std::size_t i) { return vector(at_corner_, i); };
    const CornerNeighbours<Points8> pairs{{seen(1), seen(2)}, {seen(3), seen(4)}};
    decide_all_but(FloatSeparation::are_apart(pairs).bits(), at_corner_);
  }

  void flush_edge_neighbours() {
    if (at_edge_.count() == 0) return;
    at_edge_.pad();
    const auto seen = [this](std::size_t i) { return vector(at_edge_, i); };
    const EdgeNeighbours<Points8> pairs{seen(1), seen(2), seen(3)};
    decide_all_but(FloatSeparation::are_apart(pairs).bits(), at_edge_);
  }

  void decide_all_but(unsigned apart, Batch8<WaitingNeighbours>& waiting) {
    for (SetBits lane(~apart & ((1u << waiting.count()) - 1)); lane; ++lane)
      decide(waiting[*lane].a, waiting[*lane].b);
    waiting.clear();
  }

  /// A vertex of each pair, seen from the first one.
  MovingVector<Points8> vector(const Batch8<WaitingNeighbours>& waiting, std::size_t number) const {
    const auto gather = [&](Positions positions, std::size_t i) {
      return gather_points(
          [&](std::uint32_t lane) { return positions[waiting[lane].vertices[i]].data(); });
    };
    return {gather(positions_.from, number) - gather(positions_.from, 0),
            gather(positions_.to, number) - gather(positions_.to, 0)};
  }

  /// The triangle with the lower number is that of `a`, as in SelfMovingPairs.
  void decide(std::uint32_t a, std::uint32_t b) {
    if (ids_[b] < ids_[a]) return decide(b, a);
    const auto contact = decide_neighbours(read(a), read(b), {ids_[a], ids_[b]}, options_, work_);
    if (contact) sink_.push(*contact);
  }

  MovingSurfaceTriangle read(std::uint32_t place) {
    return {{from_.corners(ids_[place], work_), to_.corners(ids_[place], work_)},
            fans_.corners.data()[place]};
  }

  const std::uint32_t* ids_;
  const Fans& fans_;
  MovingPositions positions_;
  TriangleReader from_, to_;
  const MovingOptions& options_;
  FilteredSink<MovingContact>& sink_;
  MovingStats& work_;
  Batch8<WaitingNeighbours> at_corner_, at_edge_;
};

}  // namespace

bool test_fans(const PosedTree& posed, const Fans& fans, Positions positions, float* slack,
               FilteredSink<Contact>& sink, QueryStats& work) {
  FanPairs pairs(posed, fans, positions, sink, work);
  for (const FanRun& run : fans.runs)
    if (!(can_be_flat(run.kind) ? test_flat(fans, run, positions, slack, pairs, sink)
                                : test_run(run, pairs, sink)))
      return true;
  return false;
}

bool test_moving_fans(const MovingTree& moving, const Fans& fans, const MovingPositions& positions,
                      const MovingOptions& options, FilteredSink<MovingContact>& sink,
                      MovingStats& work) {
  MovingFanPairs pairs(moving, fans, positions, options, sink, work);
  for (const FanRun& run : fans.runs)
    if (!test_run(run, pairs, sink)) return true;
  pairs.flush();
  return sink.is_full();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
