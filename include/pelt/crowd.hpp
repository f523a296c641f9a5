#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>
#include <pelt/self_collide.hpp>

#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct Crowd;
}

/// Selects the pairs of instances that are tested, by layers. Instances a and b are tested if a is
/// a member of a layer that b collides with, and b is a member of a layer that a collides with.
struct CollisionMask {
  std::uint32_t member_of = 1;               ///< one bit per layer
  std::uint32_t collides_with = 0xFFFFFFFF;  ///< one bit per layer
};

/// Two intersecting instances, a < b, or an instance that intersects itself, a == b.
struct CrowdPair {
  std::uint32_t instance_a = 0, instance_b = 0;

  friend auto operator<=>(const CrowdPair&, const CrowdPair&) = default;
};

/// Two intersecting triangles of two instances, or of one, with their indices in the instances'
/// models. For one instance, triangle_a < triangle_b.
struct CrowdContact {
  std::uint32_t instance_a = 0, instance_b = 0;  ///< a <= b
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const CrowdContact&, const CrowdContact&) = default;
};

struct CrowdOptions {
  /// Number of threads, including the caller's. 0 means one per core. Answers and stats do not
  /// depend on it.
  std::uint32_t threads = 0;

  /// Stop each pair of instances, and each instance against itself, after this number of contacts;
  /// see CollideOptions.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();

  /// Called for pairs a < b whose bounds overlap and whose collision masks match; return false to
  /// skip the pair. Empty: no pair is skipped. Runs on the caller's thread, before the query uses
  /// any other thread, so it may read any data of the caller. (A std::function is fast enough here,
  /// because it is called once per pair of instances. It allocates nothing for a lambda that
  /// captures by reference.)
  std::function<bool(std::uint32_t instance_a, std::uint32_t instance_b)> filter = nullptr;

  /// Called for each instance; return the filter with which to test the instance against itself, or
  /// null for no such test. Empty: no instance is tested against itself. `filter` and collision
  /// masks do not matter for these tests. The SelfFilter must be of the model of the instance
  /// (otherwise the program aborts, in every build), and must live until the query returns. Runs on
  /// the caller's thread, like `filter`.
  std::function<const SelfFilter*(std::uint32_t instance)> self_filter = nullptr;
};

/// Work of a query of a crowd, summed over all threads.
struct CrowdStats : QueryStats {
  std::uint64_t candidate_pairs = 0;     ///< pairs of instances that were tested for contacts
  std::uint64_t intersecting_pairs = 0;  ///< candidate pairs with contacts
  std::uint64_t self_tests = 0;          ///< instances that were tested against themselves
  std::uint64_t self_intersecting = 0;   ///< of these, instances with contacts
  LeftOut left_out;                      ///< what the filters of these tests have left out
};

/// Up to tens of thousands of instances of a few models, which are queried together. An instance
/// stores little more than its joint palette. Queries store opened nodes in memory that all
/// instances share. A query divides the pairs of instances into sets that have no instance in
/// common, and recycles the memory of a set's nodes when all pairs of the set have been tested.
///
/// In each frame, call `set_palette` for the instances that have moved, then a query. Instances are
/// numbered from 0. Functions without a stated cost take O(1).
///
/// Only one thread at a time may use a crowd, except for `set_palette`. Movable, not copyable.
class PELT_API Crowd {
 public:
  Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;
  ~Crowd();

  /// Adds an instance in the rest pose and returns its number: the number of a removed instance, or
  /// the lowest number never used.
  ///
  /// Cost: O(J). Allocates. If memory runs out, throws std::bad_alloc and the crowd is unchanged.
  std::uint32_t add(const SkinnedModel& model, const CollisionMask& mask = {});

  /// Removes an instance.
  ///
  /// Precondition, also of the functions below that have a parameter `instance`: `instance` was
  /// returned by `add` and has not been removed since.
  void remove(std::uint32_t instance);

  /// Number of instances.
  std::uint32_t size() const;

  const SkinnedModel& model(std::uint32_t instance) const;

  void set_collision_mask(std::uint32_t instance, const CollisionMask& mask);

  /// Copies the joint palette of an instance, or returns an error, like Pose::set_palette. Also
  /// computes the box of the instance. Several threads may set palettes of different instances at
  /// the same time.
  ///
  /// Cost: O(J). Each morph weight other than 0 adds at most O(J). Allocates nothing.
  Result<void> set_palette(std::uint32_t instance, std::span<const Matrix4> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const float> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const Matrix3x4> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const double> palette);

  /// Copies the morph weights of an instance, or returns an error, like Pose::set_morph_weights.
  /// Also computes the box of the instance.
  ///
  /// Cost: O(M + J). Each weight other than 0 adds at most O(J). Allocates nothing.
  Result<void> set_morph_weights(std::uint32_t instance, std::span<const float> weights);

  /// Appends all contacts of all pairs of instances to `contacts`, in ascending order, with those
  /// of instances with themselves if `CrowdOptions::self_filter` asks for them. Exact like
  /// `collide` of two poses and like `self_collide`.
  ///
  /// Cost: the broad phase runs on one thread. For n instances it takes O(n log n) to sort the
  /// boxes along the axis with the largest spread, and one comparison per pair of boxes that
  /// overlap along this axis. Eight pairs are compared at a time. The remaining work runs on all
  /// threads: each pair with overlapping boxes costs as much as `collide`, and each instance that
  /// is tested against itself as much as `self_collide`, but an instance that is in several tests
  /// opens each node only once. One thread tests an instance against itself.
  ///
  /// Allocates if there are more pairs, more contacts or more nodes to open than in any earlier
  /// query, and for the first query with more threads. A frame that resembles earlier frames
  /// allocates nothing, even if the work is distributed differently among the threads. There is no
  /// `reserve`, because it would need memory for all nodes of all instances, once per thread.
  /// Callers that must never allocate should query reserved poses instead.
  ///
  /// Failure: if memory runs out on any thread, throws std::bad_alloc on the caller's thread.
  /// `contacts` is then unchanged, and the crowd can be queried again.
  CrowdStats collide(std::vector<CrowdContact>& contacts, const CrowdOptions& options = {});

  /// Appends the pairs of intersecting instances to `pairs`, in ascending order, with a pair (i, i)
  /// for each tested instance i that intersects itself. Like `collide`, but cheaper, because each
  /// test ends at its first contact. Ignores `max_contacts`.
  CrowdStats intersecting_pairs(std::vector<CrowdPair>& pairs, const CrowdOptions& options = {});

  /// Bytes of memory of the crowd, without its models. O(n).
  std::size_t memory_bytes() const;

 private:
  std::unique_ptr<detail::Crowd> crowd_;
};

}  // namespace pelt
