#pragma once

/// Self-contacts of a character in motion. From one frame to the next, most of a surface moves
/// almost rigidly with some joint. `SelfTracker` remembers how far neighbouring triangles were
/// apart, and skips those that cannot have come together since.

#include <pelt/cxx20.hpp>

#include <pelt/self_collide.hpp>

namespace pelt {

namespace detail {
struct SelfTrack;
}

/// Results of earlier frames that remain valid for similar poses. Create one tracker per body, and
/// use it for every frame. Poses may follow each other in any order, but time is saved only if a
/// pose is similar to the one before.
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
/// `tracker`: of the model of `pose`. Otherwise the program aborts, in every build. Not used by
/// another thread at the same time.
/// `scratch`: as in `self_collide`.
///
/// Cost: less than `self_collide` if the surface moves almost rigidly with its joints: neighbouring
/// triangles are tested again only after they have moved far enough, relative to a joint, to touch.
/// The first call, and a call after a large change, cost up to twice as much as `self_collide`.
///
/// Allocates only in the pose, in `scratch` and in `contacts`, as `self_collide` does.
PELT_API SelfStats self_collide(Pose& pose, SelfTracker& tracker, Scratch& scratch,
                                std::vector<Contact>& contacts, const CollideOptions& options = {});

}  // namespace pelt
