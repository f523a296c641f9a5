#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/motion.hpp>
#include <pelt/search.hpp>

#include <cstdint>
#include <memory>
#include <optional>

namespace pelt {

namespace detail {
struct SearchOfMotions;
}

/// A `first_contact` that can be stopped after any amount of work, read, and resumed.
///
///     FirstContactSearch search(a, b);
///     while (!search.is_complete() && frame_has_time()) search.advance(20'000);
///     const float free_until = search.apart_until();
///
/// After any amount of work:
/// - `a` and `b` are apart at all times before `apart_until`, which never falls.
/// - `earliest` is a contact of `collide_moving`, with the same time and features. More work
///   replaces it only by a contact that is earlier, or that has exactly the same time and a lower
///   pair of triangles.
/// - The first time lies between `apart_until()` and `earliest()->time`. If they are equal, this
///   float is the final time; further work can only replace the pair and its features.
/// - When nothing is open, `earliest` is the answer of `first_contact`, bit for bit.
///
/// With `leave_out_start`, pairs of triangles that intersect at time 0 do not count as touching.
///
/// The search visits pairs of nodes in the order of the earliest times at which their boxes
/// overlap, so `apart_until` rises soon. `earliest` is empty until the first contact is found.
///
/// The state of a search depends only on the poses, the options, `max_open` and `work_done`, with
/// the exception that `CollisionSearch` describes. It does not depend on the instruction set, the
/// compiler, the size of the slices, or on which nodes other queries have opened.
///
/// Work is counted in the units of `CollisionSearch`, with the constants for motions in
/// `query.hpp`. One pair of triangles that needs exact arithmetic takes 24,000 units, so `advance`
/// may exceed small slices by far (`longest_step`). Slices of 20,000 units or more are adequate. A
/// node is opened in both poses of a motion. Opening it in a pose counts when the search first
/// needs it there, even if it is open already. `advance` reads no clock. To spend a certain time,
/// call `advance` with small slices.
///
/// Only one thread at a time may use a search or its poses. The poses must outlive the search.
/// Movable, not copyable. A moved-from search may only be assigned to or destroyed.
class PELT_API FirstContactSearch {
 public:
  /// Default of `max_open`.
  static constexpr std::uint32_t kMaxOpen = CollisionSearch::kMaxOpen;

  /// Starts a search by comparing the boxes of the four poses.
  ///
  /// `max_open`: limit of the number of open pairs of nodes or clusters. Beyond the limit, the
  ///   search finishes the pair that it has begun before it begins another one, and `apart_until`
  ///   rises later.
  ///
  /// Preconditions: both poses of a motion are of one model, and may be one pose. `a` and `b` have
  /// no pose in common. Otherwise the program aborts, in every build.
  ///
  /// Cost: O(J). Allocates.
  FirstContactSearch(const Motion& a, const Motion& b, const FirstContactOptions& options = {},
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
  /// `cut_short` says whether anything is left open.
  ///
  /// A search consists of steps. A step begins only while granted work is left, and is then
  /// finished. Work beyond `work` is subtracted from the next call, so several calls are equivalent
  /// to one call with the sum of their work.
  ///
  /// Precondition: the poses have not changed since the search was started (`is_stale`). Otherwise
  /// the program aborts in builds without NDEBUG, and in other builds nothing happens.
  ///
  /// Cost: searching to the end costs about as much as `first_contact`, and several times as
  /// much if triangles intersect at time 0. Allocates only if it needs more memory in the poses or
  /// in the search than any earlier search.
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
