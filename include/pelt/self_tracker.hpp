#pragma once

/// Self-collision of a character in motion. From one frame to the next, most of a surface moves
/// almost rigidly with some joint. For neighbouring parts of the surface, `SelfTracker` stores how
/// far they can still move before their triangles might intersect, and skips them until then.

#include <pelt/cxx20.hpp>

#include <pelt/self_collide.hpp>

namespace pelt {

namespace detail {
struct SelfTrack;
}

/// Results of earlier frames that remain valid for similar poses. Create one tracker per instance,
/// and use it for every frame. Poses may follow each other in any order, but a tracker saves time
/// only if a pose is similar to the previous one.
class PELT_API SelfTracker {
 public:
  /// Shares `filter`.
  ///
  /// Cost: O(T log T). Allocates.
  explicit SelfTracker(const SelfFilter& filter);
  SelfTracker(SelfTracker&&) noexcept;
  SelfTracker& operator=(SelfTracker&&) noexcept;
  ~SelfTracker();

  const SelfFilter& filter() const;

  /// Bytes of memory, without the filter: about 30 bytes per triangle.
  std::size_t memory_bytes() const;

  /// For internal use.
  detail::SelfTrack& detail() { return *track_; }

 private:
  std::unique_ptr<detail::SelfTrack> track_;
};

/// Appends the same contacts as `self_collide` with `tracker.filter()`, in the same order. If
/// `max_contacts` ends the query early, the contacts may differ from those found without a tracker.
///
/// Preconditions:
/// `tracker`: its filter was made for the model of `pose`. Otherwise the program aborts, in every
///   build. Not used by another thread at the same time.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: less than `self_collide` without a tracker if the surface moves almost rigidly with its
/// joints. Neighbouring parts of the surface are then tested again only after they have moved so
/// far, relative to a joint, that their triangles might intersect. The first call, and a call after
/// a large change, cost up to twice as much as `self_collide` without a tracker.
///
/// Allocates only if it needs more memory in the pose, in `scratch` or in `contacts` than any
/// earlier query.
PELT_API SelfStats self_collide(Pose& pose, SelfTracker& tracker, Scratch& scratch,
                                std::vector<Contact>& contacts, const CollideOptions& options = {});

}  // namespace pelt
