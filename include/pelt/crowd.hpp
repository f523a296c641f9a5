#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>

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

/// Which instances of a crowd are asked about at all. Instances a and b are, if a is in a group
/// that b collides with and b is in a group that a collides with.
struct CrowdGroups {
  std::uint32_t member_of = 1;               ///< a bit for each group
  std::uint32_t collides_with = 0xFFFFFFFF;  ///< a bit for each group
};

/// Two instances that intersect, a < b.
struct CrowdPair {
  std::uint32_t instance_a = 0, instance_b = 0;

  friend auto operator<=>(const CrowdPair&, const CrowdPair&) = default;
};

/// Two triangles of two instances that intersect, by their numbers in the instances' models.
struct CrowdContact {
  std::uint32_t instance_a = 0, instance_b = 0;  ///< a < b
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const CrowdContact&, const CrowdContact&) = default;
};

struct CrowdOptions {
  /// Threads that work on the query, the caller's included; 0: as many as the machine has cores.
  /// Answers and stats do not depend on it.
  std::uint32_t threads = 0;

  /// Stop each pair of instances after this many contacts; see CollideOptions.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();

  /// Asked for pairs a < b whose bounds overlap and whose groups agree: whether to go on with them.
  /// Empty: always. Runs on the caller's thread before any other work is done, so it may read
  /// whatever the caller may. (A std::function because it is asked once for a pair, not for a
  /// triangle, and a lambda that captures by reference then allocates nothing.)
  std::function<bool(std::uint32_t instance_a, std::uint32_t instance_b)> filter = nullptr;
};

/// The work of a query of a crowd, on all threads.
struct CrowdStats : QueryStats {
  std::uint64_t candidate_pairs = 0;     ///< pairs of instances that were tested for contacts
  std::uint64_t intersecting_pairs = 0;  ///< those of them that have contacts
};

/// Many instances of a few models, asked all at once which of them intersect: up to tens of
/// thousands. An instance costs its joint palette and a few words; what a query opens of it lies in
/// memory that is shared by all, and used anew as soon as the pairs of instances that hang together
/// are through. Functions below that state no cost take O(1).
///
/// A frame is `set_palette` for the instances that have moved, then a query. Instances have numbers
/// from 0 on. One thread at a time may use a crowd, but for `set_palette`. Movable, not copyable.
class PELT_API Crowd {
 public:
  Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;
  ~Crowd();

  /// Adds an instance, in the rest pose until it gets a palette, and returns its number: the least
  /// that no instance ever had, or that of a removed one. O(J), allocates. If memory ends, throws
  /// std::bad_alloc and the crowd is as before.
  std::uint32_t add(const SkinnedModel& model, const CrowdGroups& groups = {});

  /// Removes an instance. Precondition of this and of all that follow: `add` returned the number,
  /// and the instance has not been removed since.
  void remove(std::uint32_t instance);

  /// Instances that there are.
  std::uint32_t size() const;

  const SkinnedModel& model(std::uint32_t instance) const;

  void set_groups(std::uint32_t instance, const CrowdGroups& groups);

  /// Takes the joint palette of an instance, or refuses it, as Pose::set_palette does. Several
  /// threads may set palettes of different instances at once. Copies it and takes the box around
  /// the instance; O(J), allocates nothing.
  Result<void> set_palette(std::uint32_t instance, std::span<const Matrix4> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const float> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const Matrix3x4> palette);
  Result<void> set_palette(std::uint32_t instance, std::span<const double> palette);

  /// The same for the weights of an instance's morph targets, as Pose::set_morph_weights.
  Result<void> set_morph_weights(std::uint32_t instance, std::span<const float> weights);

  /// Appends all contacts of all pairs of instances, in ascending order; exact as `collide` of two
  /// poses.
  ///
  /// Of n instances, O(n log n) to sort their boxes along the axis on which they are spread most,
  /// and as many comparisons as boxes overlap along that axis, eight at once; one thread does
  /// these. Then, on all threads, what `collide` costs for each pair whose boxes overlap, but that
  /// a node is opened once for all pairs of its instance.
  ///
  /// Allocates when there are more pairs, more contacts or more to open than in any query before,
  /// and for the first query with more threads; a frame that is like earlier ones allocates
  /// nothing, whichever thread does what. There is no `reserve`: it would have to make room for all
  /// that all instances could open, once for each thread. Who must never allocate asks reserved
  /// poses.
  ///
  /// If memory ends on any thread, throws std::bad_alloc on the caller's thread. `contacts` is then
  /// unchanged, and the crowd can be queried again.
  CrowdStats collide(std::vector<CrowdContact>& contacts, const CrowdOptions& options = {});

  /// Appends the pairs of instances that intersect, in ascending order: cheaper, for a pair is done
  /// with its first contact. Otherwise as `collide`; `max_contacts` does not count.
  CrowdStats intersecting_pairs(std::vector<CrowdPair>& pairs, const CrowdOptions& options = {});

  /// Bytes that the crowd holds, without its models. O(n).
  std::size_t memory_bytes() const;

 private:
  std::unique_ptr<detail::Crowd> crowd_;
};

}  // namespace pelt
