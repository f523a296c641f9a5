#include "self/moving_fans.hpp"

#include "query/find_triangle.hpp"
#include "query/triangle_batch.hpp"
#include "self/decide_neighbours.hpp"
#include "self/neighbour_triage.hpp"
#include "self/shared_corners.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

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
                 const MovingOptions& options, SelfAnswerOf<MovingContact>& answer,
                 MovingStats& work)
      : ids_(moving.tree.triangle_ids.data()),
        fans_(fans),
        positions_(positions),
        from_(moving.from),
        to_(moving.to),
        options_(options),
        answer_(answer),
        work_(work) {}

  /// Adds all pairs of triangles of a fan.
  void test_fan(const FanRun& run, std::uint32_t fan) {
    const FanTriangle* const triangles = fans_.triangles.data() + run.triangle_of(fan);
    const std::uint32_t vertex = fans_.corners.data()[triangles->place()][triangles->corner()];
    const bool is_simple = can_be_flat(run.kind);
    for (std::uint32_t k = 1; k < run.size; ++k)
      for (std::uint32_t i = 0; i < k && !answer_.is_full(); ++i) {
        const std::uint32_t a = triangles[k].place(), b = triangles[i].place();
        if (share_lower(a, b, vertex)) continue;
        ++work_.triangle_pairs;
        is_simple ? add(a, b) : decide(a, b);
      }
  }

  void flush() {
    flush_corner_neighbours();
    flush_edge_neighbours();
  }

 private:
  /// Triangles that share several vertices are tested once, in the fan of the lowest.
  bool share_lower(std::uint32_t a, std::uint32_t b, std::uint32_t vertex) const {
    const SurfaceCorners &corners_a = fans_.corners.data()[a], &corners_b = fans_.corners.data()[b];
    for (const std::uint32_t v : corners_a)
      if (v < vertex && has_corner(corners_b, v)) return true;
    return false;
  }

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
    decide_all_but(certainly_apart(CornerNeighbours8{{seen(1), seen(2)}, {seen(3), seen(4)}}),
                   at_corner_);
  }

  void flush_edge_neighbours() {
    if (at_edge_.count() == 0) return;
    at_edge_.pad();
    const auto seen = [this](std::size_t i) { return vector(at_edge_, i); };
    decide_all_but(certainly_apart(EdgeNeighbours8{seen(1), seen(2), seen(3)}), at_edge_);
  }

  void decide_all_but(unsigned apart, Batch8<WaitingNeighbours>& waiting) {
    for (SetBits lane(~apart & ((1u << waiting.count()) - 1)); lane; ++lane)
      decide(waiting[*lane].a, waiting[*lane].b);
    waiting.clear();
  }

  /// A vertex of each pair, seen from the first one.
  MovingVector<Points8> vector(const Batch8<WaitingNeighbours>& waiting, std::size_t number) const {
    const auto gather = [&](const std::array<float, 4>* positions, std::size_t i) {
      return gather_points(
          [&](std::uint32_t lane) { return positions[waiting[lane].vertices[i]].data(); });
    };
    return {gather(positions_.from, number) - gather(positions_.from, 0),
            gather(positions_.to, number) - gather(positions_.to, 0)};
  }

  void decide(std::uint32_t a, std::uint32_t b) {
    decide_neighbours(read(a), read(b), {ids_[a], ids_[b]}, options_, answer_.contacts(), work_);
    answer_.settle();
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
  SelfAnswerOf<MovingContact>& answer_;
  MovingStats& work_;
  Batch8<WaitingNeighbours> at_corner_, at_edge_;
};

}  // namespace

bool test_moving_fans(const MovingTree& moving, const Fans& fans, const MovingPositions& positions,
                      const MovingOptions& options, SelfAnswerOf<MovingContact>& answer,
                      MovingStats& work) {
  MovingFanPairs pairs(moving, fans, positions, options, answer, work);
  for (const FanRun& run : fans.runs)
    for (std::uint32_t fan = run.first_fan; fan < run.end; ++fan) {
      pairs.test_fan(run, fan);
      if (answer.is_full()) return true;
    }
  pairs.flush();
  return answer.is_full();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
