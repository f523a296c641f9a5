#pragma once

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/math.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct SearchOfMotions;
struct SearchOfPoses;
}  // namespace detail

/// Units of work per count of QueryStats, and per pair of clusters (up to 16 triangles each) of a
/// `CollisionSearch`. These numbers never change, because budgets and partial answers depend on
/// them.
inline constexpr std::uint64_t kNodePairWork = 8, kRefitWork = 5, kPosedVertexWork = 2,
                               kTrianglePairWork = 1, kDisplacementWork = 2, kClusterPairWork = 8;

/// Units of work of a `FirstContactSearch`: per pair of nodes and of clusters that move, and per
/// test of a pair of triangles in float, in double and in exact arithmetic. A pair that is tested
/// in several ways counts in each. These numbers never change, either.
inline constexpr std::uint64_t kMovingNodePairWork = 24, kMovingClusterPairWork = 24,
                               kMovingTrianglePairWork = 28, kDoublePairWork = 500,
                               kExactPairWork = 24'000;

/// A decision, if certain, about two poses, two motions or two instances of a crowd.
enum class Verdict : std::uint8_t {
  apart,     ///< they do not touch
  touching,  ///< they touch
  unknown,   ///< neither is certain yet
};

/// What a search does first.
enum class SearchOrder : std::uint8_t {
  first_contact,  ///< depth first, deepest overlap first, as `intersects`: a verdict soon
  resolution,     ///< longest region first: shrinks all regions evenly
  contacts,       ///< deepest overlap first, relative to its length: many contacts soon
};

/// Triangles below two nodes that have not been compared yet.
struct OpenRegion {
  Box region;       ///< contains every contact of these triangles
  float depth = 0;  ///< least translation along an axis that separates the boxes of the two nodes
  std::uint64_t pairs = 0;  ///< number of pairs of these triangles
};

/// A `collide` that can be stopped after any amount of work, read, and resumed.
///
///     CollisionSearch search(a, b, SearchOrder::contacts);
///     while (!search.is_complete() && frame_has_time()) search.advance(2000, scratch);
///     for (const Contact& contact : search.contacts()) ...
///
/// After any amount of work:
/// - `contacts` are contacts of `collide`. More work only adds contacts.
/// - Each missing contact is a pair of triangles of an open region. The triangles have a common
///   point in the box of this region.
/// - The union of all open regions, `undecided_pairs` and `distance_bound` never grow.
/// - When nothing is open, `contacts` is the answer of `collide`, bit for bit.
///
/// The state of a search depends only on the poses, the order, `max_open` and `work_done`, but not
/// on the machine, on the size of the slices or, with one exception, on earlier queries.
/// docs/queries.md ("Why a search is certain") gives the reasons and the exception.
///
/// `advance` counts work and reads no clock. To spend a certain time, call it with small slices; a
/// unit of work takes 4 to 6 ns on an AMD EPYC core.
///
/// Only one thread at a time may use a search or its poses. The poses must outlive the search.
/// Movable, not copyable. A moved-from search may only be assigned to or destroyed.
class PELT_API CollisionSearch {
 public:
  /// Default of `max_open`.
  static constexpr std::uint32_t kMaxOpen = 4096;

  /// Starts a search by comparing the boxes of the two poses.
  ///
  /// `max_open`: limit of the number of open regions. Beyond the limit, the search finishes the
  ///   region that it has begun before it begins another one.
  ///
  /// Precondition: `a` and `b` are different poses, of one model or of two. Passing one pose twice
  /// aborts the program, in every build.
  ///
  /// Cost: O(J). Allocates.
  CollisionSearch(Pose& a, Pose& b, SearchOrder order = SearchOrder::first_contact,
                  std::uint32_t max_open = kMaxOpen);
  CollisionSearch(CollisionSearch&&) noexcept;
  CollisionSearch& operator=(CollisionSearch&&) noexcept;
  ~CollisionSearch();

  /// Allocates the memory for up to `contacts` contacts and for all open regions. `advance` then
  /// allocates nothing if the poses and its scratch are reserved, too.
  ///
  /// Memory: 52 bytes for each of `max_open` regions, 240 KB for regions beyond, and 8 bytes per
  /// contact.
  void reserve(std::size_t contacts);

  /// Starts anew with the current palettes of the same poses. Keeps the memory.
  void restart();

  /// Searches until `work` units are done, or nothing is open. In the order `first_contact`, also
  /// stops at the first contact, and drops the rest of `work`. Returns the work of this call;
  /// `cut_short` says whether regions are left open.
  ///
  /// A step of the search that has begun is finished, and work beyond `work` is subtracted from the
  /// next call. Several calls are therefore equivalent to one call with the sum of their work.
  ///
  /// Precondition: the poses have not changed since the search was started (`is_stale`). Otherwise
  /// the program aborts in builds without NDEBUG, and in other builds nothing happens.
  ///
  /// Cost: searching to the end costs about as much as `collide`. Allocates only if it needs more
  /// memory than any earlier search.
  QueryStats advance(std::uint64_t work, Scratch& scratch);

  /// Whether nothing is open.
  bool is_complete() const;

  /// Whether a pose has got a new palette or new morph weights since the search was started. The
  /// search then describes the former poses and cannot be advanced.
  bool is_stale() const;

  Verdict verdict() const;

  /// The contacts found so far, in ascending order if the search is complete, otherwise in no
  /// particular order. Valid until the next call that is not const.
  std::span<const Contact> contacts() const;

  /// Number of pairs of triangles that are not decided yet. Cost: O(open regions).
  std::uint64_t undecided_pairs() const;

  /// Longest side of any open region, in model units; 0 if nothing is open. Cost: O(open regions).
  double resolution() const;

  /// Upper bound of the distance of the poses, in model units; 0 if a contact is known.
  double distance_bound() const;

  /// Units of work done since the search was started.
  std::uint64_t work_done() const;

  /// Units of work of the longest step so far. `advance` exceeds its work by less.
  std::uint64_t longest_step() const;

  /// Appends all open regions to `regions`, in no particular order.
  void open_regions(std::vector<OpenRegion>& regions) const;

  /// For internal use.
  const detail::SearchOfPoses& detail() const { return *search_; }

 private:
  std::unique_ptr<detail::SearchOfPoses> search_;
};

/// A `first_contact` that can be stopped after any amount of work, read, and resumed.
///
///     FirstContactSearch search(a, b);
///     while (!search.is_complete() && frame_has_time()) search.advance(20'000);
///     const float free_until = search.apart_until();
///
/// After any amount of work:
/// - `a` and `b` are apart at all times before `apart_until`, which never falls.
/// - `earliest` is a contact of `collide` of two motions, with the same time and features. Only an
///   earlier contact, or one of the same time with a lower pair, can replace it.
/// - The first time lies between `apart_until()` and `earliest()->time`. Once they are equal, only
///   the pair and its features can still change.
/// - When nothing is open, `earliest` is the answer of `first_contact`, bit for bit.
///
/// With `leave_out_start`, pairs of triangles that intersect at time 0 do not count as touching.
///
/// The search visits pairs of nodes in the order of the times at which their boxes first overlap,
/// so `apart_until` rises soon. `earliest` is empty until a contact is found. The state depends on
/// the same things as that of a `CollisionSearch`.
///
/// One pair of triangles that needs exact arithmetic takes 24,000 units of work, so `advance` may
/// exceed small slices by far (`longest_step`). Slices of 20,000 units or more are adequate.
///
/// Only one thread at a time may use a search or its poses. The poses must outlive the search.
/// Movable, not copyable. A moved-from search may only be assigned to or destroyed.
class PELT_API FirstContactSearch {
 public:
  /// Default of `max_open`.
  static constexpr std::uint32_t kMaxOpen = CollisionSearch::kMaxOpen;

  /// Starts a search by comparing the boxes of the four poses. Of `options`, only
  /// `leave_out_start` applies.
  ///
  /// `max_open`: limit of the number of open pairs of nodes or clusters. Beyond the limit, the
  ///   search finishes the pair that it has begun before it begins another one, and `apart_until`
  ///   rises later.
  ///
  /// Preconditions: both poses of a motion are of one model, and may be one pose. `a` and `b` have
  /// no pose in common. Otherwise the program aborts, in every build.
  ///
  /// Cost: O(J). Allocates.
  FirstContactSearch(const Motion& a, const Motion& b, const MovingOptions& options = {},
                     std::uint32_t max_open = kMaxOpen);
  FirstContactSearch(FirstContactSearch&&) noexcept;
  FirstContactSearch& operator=(FirstContactSearch&&) noexcept;
  ~FirstContactSearch();

  /// Allocates the memory for all open pairs. `advance` then allocates nothing if the poses are
  /// reserved, too.
  ///
  /// Memory: 32 bytes for each of `max_open` pairs, and 590 KB for pairs beyond.
  void reserve();

  /// Starts anew with the current palettes of the same poses. Keeps the memory.
  void restart();

  /// Searches until `work` units are done, or nothing is open. Returns the work of this call;
  /// `cut_short` says whether anything is left open. Steps are finished as by
  /// `CollisionSearch::advance`.
  ///
  /// Precondition: the poses have not changed since the search was started (`is_stale`). Otherwise
  /// the program aborts in builds without NDEBUG, and in other builds nothing happens.
  ///
  /// Cost: searching to the end costs about as much as `first_contact`, and several times as much
  /// if triangles intersect at time 0. Allocates only if it needs more memory in the poses or in
  /// the search than any earlier search.
  MovingStats advance(std::uint64_t work);

  /// Whether nothing is open.
  bool is_complete() const;

  /// Whether a pose has got a new palette or new morph weights since the search was started. The
  /// search then describes the former poses and cannot be advanced.
  bool is_stale() const;

  /// `touching` as soon as any contact is known.
  Verdict verdict() const;

  /// Time before which the motions are certainly apart, 0 to 1. If `verdict` is `apart`, they are
  /// also apart at time 1. Cost: O(open pairs beyond `max_open`).
  float apart_until() const;

  /// The first contact of those found so far. If `at_start`, its features have no meaning.
  std::optional<MovingContact> earliest() const;

  /// Units of work done since the search was started.
  std::uint64_t work_done() const;

  /// Units of work of the longest step so far. `advance` exceeds its work by less.
  std::uint64_t longest_step() const;

  /// For internal use.
  const detail::SearchOfMotions& detail() const { return *search_; }

 private:
  std::unique_ptr<detail::SearchOfMotions> search_;
};

}  // namespace pelt
