#pragma once

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>
#include <pelt/search.hpp>
#include <pelt/self_filter.hpp>

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

/// Two intersecting instances, with instance_a < instance_b, or one instance that intersects
/// itself, with instance_a == instance_b.
struct CrowdPair {
  std::uint32_t instance_a = 0, instance_b = 0;

  friend auto operator<=>(const CrowdPair&, const CrowdPair&) = default;
};

/// Two intersecting triangles, as indices into the triangle arrays of the models of the instances.
/// instance_a <= instance_b. If both are the same instance, triangle_a < triangle_b.
struct CrowdContact {
  std::uint32_t instance_a = 0, instance_b = 0;
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const CrowdContact&, const CrowdContact&) = default;
};

/// Two triangles that intersect at some time of a step. instance_a <= instance_b. If both are the
/// same instance, triangle_a < triangle_b.
struct CrowdMovingContact {
  std::uint32_t instance_a = 0, instance_b = 0;
  MovingContact moving;  ///< of a triangle of instance_a and one of instance_b

  friend bool operator==(const CrowdMovingContact&, const CrowdMovingContact&) = default;
};

struct CrowdOptions {
  /// Number of threads, including the caller's thread. 0 means one per core. Answers and stats do
  /// not depend on the number of threads.
  std::uint32_t threads = 0;

  /// Stop the test of each pair of instances, and of each instance against itself, after this
  /// number of contacts, as with `Limits::max_contacts`.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();

  /// Called once for each pair of instances whose boxes overlap and whose collision masks match,
  /// with instance_a < instance_b. Return false to skip the pair. Without a filter, no pair is
  /// skipped. The filter runs on the caller's thread, before the query uses any other thread, so
  /// the filter may read any data of the caller.
  std::function<bool(std::uint32_t instance_a, std::uint32_t instance_b)> filter = nullptr;

  /// Called once for each instance, on the caller's thread. Return the SelfFilter with which to
  /// test the instance against itself, or null to skip this test; without this function, all are
  /// skipped. `filter` and collision masks do not apply to these tests. Precondition: the
  /// SelfFilter is of the model of the instance (otherwise the program aborts) and lives until the
  /// query returns.
  std::function<const SelfFilter*(std::uint32_t instance)> self_filter = nullptr;
};

/// How much work `Crowd::search` may do, and for which pairs first. Work is in the units of
/// `CollisionSearch`.
struct CrowdBudget {
  /// Of all pairs together. Each pair may exceed its part of the work by less than one step.
  std::uint64_t work = std::numeric_limits<std::uint64_t>::max();

  /// Work of each undecided pair in each round, at least 1. 0 aborts the program, in every build.
  std::uint64_t slice = 2000;

  /// Order of the search of each pair. In the order `first_contact`, a pair is decided by its first
  /// contact; otherwise, when its search is complete.
  SearchOrder order = SearchOrder::first_contact;

  /// Limit of the number of open regions of each pair, see `CollisionSearch`.
  std::uint32_t max_open = CollisionSearch::kMaxOpen;

  /// Called once for each pair with instance_a < instance_b, on the caller's thread. If the work
  /// does not suffice for a round, the pairs with the largest weights come first; of equal ones,
  /// the lowest pairs. Without this function, all weights are equal. A NaN weight aborts the
  /// program, in every build.
  std::function<double(std::uint32_t instance_a, std::uint32_t instance_b)> weight = nullptr;
};

/// What is certain about two instances that `Crowd::search` has not decided.
struct UndecidedPair {
  CrowdPair instances;
  Verdict verdict = Verdict::unknown;  ///< unknown or touching
  std::uint64_t pairs = 0;             ///< undecided pairs of triangles
  double resolution = 0;               ///< longest side of any open region
  double distance_bound = 0;           ///< upper bound of the distance

  friend bool operator==(const UndecidedPair&, const UndecidedPair&) = default;
};

/// Work of a query of a crowd, summed over all threads.
struct CrowdStats : QueryStats {
  std::uint64_t candidate_pairs = 0;     ///< pairs of instances that were tested for contacts
  std::uint64_t intersecting_pairs = 0;  ///< candidate pairs with contacts
  std::uint64_t self_tests = 0;          ///< instances that were tested against themselves
  std::uint64_t self_intersecting = 0;   ///< instances that intersect themselves
  LeftOut left_out;                      ///< pairs of triangles left out by `self_filter`
};

/// Up to tens of thousands of instances of a few models, which are queried together. In each frame,
/// call `set_palette` for the instances that have moved, and then a query. Instances are numbered
/// from 0. Functions without a stated cost take O(1).
///
/// Memory: an instance stores little more than its joint palette. Opened nodes are in memory that
/// all instances share. A query divides the pairs of instances into islands: pairs with a common
/// instance are in the same island. When all pairs of an island have been tested, the query
/// recycles the memory of the nodes of this island.
///
/// Only one thread at a time may use a crowd. For an exception, see `set_palette`. Movable, not
/// copyable.
class PELT_API Crowd {
 public:
  Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;
  ~Crowd();

  /// Adds an instance in the rest pose and returns its number. Numbers of removed instances are
  /// reused first.
  ///
  /// Cost: O(J). Allocates. If memory runs out, throws an exception (see pelt/pelt.hpp), and the
  /// crowd is unchanged.
  std::uint32_t add(const SkinnedModel& model, const CollisionMask& mask = {});

  /// Removes an instance.
  ///
  /// Precondition of all functions with a parameter `instance`: `instance` was returned by `add`
  /// and has not been removed since.
  void remove(std::uint32_t instance);

  /// Number of instances.
  std::uint32_t size() const;

  const SkinnedModel& model(std::uint32_t instance) const;

  void set_collision_mask(std::uint32_t instance, const CollisionMask& mask);

  /// Copies the joint palette of an instance, or returns an error, like Pose::set_palette. Also
  /// computes the box of the instance. Several threads may set palettes of different instances at
  /// the same time.
  ///
  /// Cost: O(J). Each morph weight other than 0 adds at most O(J). Allocates nothing, unless a step
  /// begins (see `begin_step`).
  Result<void> set_palette(std::uint32_t instance, const JointMatrices& palette);

  /// Copies a joint palette of dual quaternions, or returns an error, like
  /// Pose::set_dual_quaternions. Otherwise like `set_palette`.
  Result<void> set_dual_quaternions(std::uint32_t instance,
                                    std::span<const float> dual_quaternions);

  /// Copies the morph weights of an instance, or returns an error, like Pose::set_morph_weights.
  /// Also computes the box of the instance.
  ///
  /// Cost: O(M + J). Each weight other than 0 adds at most O(J). Allocates nothing, unless a step
  /// begins.
  Result<void> set_morph_weights(std::uint32_t instance, std::span<const float> weights);

  /// Copies the positions of all vertices of an instance, or returns an error, like
  /// Pose::set_vertices. Several threads may call it for different instances at the same time.
  ///
  /// Cost: O(V). Allocates 16 bytes per vertex in the first call for the instance, and the same
  /// again in its first step.
  Result<void> set_vertices(std::uint32_t instance, std::span<const Vec3> vertices);

  /// Borrows offsets of the vertices of an instance, or returns an error, like Pose::set_offsets.
  /// Also computes the box of the instance. The offsets of the start of a step must live as long as
  /// the step.
  ///
  /// Cost: O(J). Allocates nothing, unless a step begins.
  Result<void> set_offsets(std::uint32_t instance, std::span<const Vec3> offsets);

  /// Begins a step for `collide` of motions: the current poses of all instances become the start of
  /// the step. The first `set_palette`, `set_dual_quaternions`, `set_morph_weights`, `set_vertices`
  /// or `set_offsets` of an instance after this call then begins its motion. Later calls change the
  /// end of the motion. An instance without such a call stands still, and so does every instance of
  /// a crowd for which no step was ever begun.
  ///
  /// Cost: O(1). However, the first of these calls for an instance in a step also copies its
  /// palette, and allocates if it is the first one of the instance.
  void begin_step();

  /// Sets the palettes of an instance at both ends of the current step, or returns an error for a
  /// palette that `set_palette` refuses. On error, the instance stands still in its present pose.
  /// Morph weights at both ends are the present ones. `collide` uses the palette `to`.
  ///
  /// Cost: that of two calls of `set_palette`. Allocates in the first call for the instance.
  Result<void> set_motion(std::uint32_t instance, const JointMatrices& from,
                          const JointMatrices& to);

  /// Like `set_motion`, with palettes of dual quaternions. Returns an error for a palette that
  /// `set_dual_quaternions` refuses.
  Result<void> set_motion_dual_quaternions(std::uint32_t instance, std::span<const float> from,
                                           std::span<const float> to);

  /// Tests pairs of instances against each other, and instances against themselves. `options` and
  /// the collision masks select the tests. Appends all contacts to `contacts`, in ascending order.
  /// Exact like `collide` of two poses and `self_collide`.
  ///
  /// Cost: first, one thread finds the pairs of instances with overlapping boxes. It sorts the
  /// boxes of the n instances along the axis with the largest spread, in O(n log n). It then
  /// compares all pairs of boxes that overlap along this axis, eight pairs at a time.
  ///
  /// The tests then run on all threads, each test on one thread. A pair costs as much as `collide`
  /// of two poses, and an instance against itself as much as `self_collide`. However, an instance
  /// that is in several tests opens each node only once.
  ///
  /// Allocates if there are more pairs, contacts, opened nodes or threads than in any earlier
  /// query. A frame that resembles earlier frames allocates nothing, even if the work is
  /// distributed differently among the threads. There is no `reserve`, because it would need memory
  /// for all nodes of all instances, once per thread. Callers that must never allocate should query
  /// reserved poses instead.
  ///
  /// If memory runs out on any thread, throws an exception (see pelt/pelt.hpp) on the caller's
  /// thread. `contacts` is then unchanged, and the crowd can be queried again.
  CrowdStats collide(std::vector<CrowdContact>& contacts, const CrowdOptions& options = {});

  /// Appends the pairs of intersecting instances to `pairs`, in ascending order. An instance i that
  /// intersects itself is the pair (i, i). Selects the same tests as `collide`, but costs less,
  /// because each test ends at its first contact. Ignores `CrowdOptions::max_contacts`.
  CrowdStats intersecting_pairs(std::vector<CrowdPair>& pairs, const CrowdOptions& options = {});

  /// Appends the triangles that intersect at any time of the current step, in ascending order of
  /// the instances and triangles. Exact like `collide` of two motions and
  /// `self_collide` of a motion.
  ///
  /// `moving`: as for two motions. `moving.max_contacts` is the limit of each pair of instances,
  /// and of each instance against itself. `options`: selects the tests. `max_contacts` is ignored.
  ///
  /// Cost, threads, allocation and exceptions: as `collide`. The broad phase compares boxes around
  /// both ends of the motions.
  CrowdStats collide(std::vector<CrowdMovingContact>& contacts, const CrowdOptions& options = {},
                     const MovingOptions& moving = {});

  /// Searches the pairs of instances for contacts, with a limit of the work. Appends the contacts
  /// that were found to `contacts`, and the pairs that are not decided to `undecided`, both in
  /// ascending order. Collision masks, `CrowdOptions::filter` and `threads` apply; instances are
  /// not tested against themselves, and `max_contacts` is ignored. Without a limit, and in another
  /// order than `first_contact`, finds the contacts of `collide`.
  ///
  /// The search proceeds in rounds. Each round gives the same work to all undecided pairs, so easy
  /// pairs are decided soon, and no hard pair takes the work of all others. Contacts, undecided
  /// pairs and stats do not depend on the number of threads, the instruction set or the compiler.
  ///
  /// Cost: `budget.work`, and O(J) for each pair. Opened nodes stay in memory until the search
  /// ends. Allocates like `collide`.
  CrowdStats search(std::vector<CrowdContact>& contacts, std::vector<UndecidedPair>& undecided,
                    const CrowdBudget& budget, const CrowdOptions& options = {});

  /// Bytes of memory of the crowd, without its models. O(n).
  std::size_t memory_bytes() const;

 private:
  std::unique_ptr<detail::Crowd> crowd_;
};

}  // namespace pelt
