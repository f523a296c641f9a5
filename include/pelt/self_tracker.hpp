#pragma once

/// Self-contacts of a character in motion. From one frame to the next, most of a surface moves
/// almost rigidly with some joint. `SelfTracker` remembers by how much neighbouring triangles were
/// apart, and skips those that cannot have come together since.

#include <pelt/cxx20.hpp>

#include <pelt/self_collide.hpp>

namespace pelt {

namespace detail {
struct SelfTrack;
}

/// What one body's last frame proves about its next one. Create one per body, and give it every
/// frame. It may be used for any pose of the model, in any order; it saves time where the pose
/// changes little.
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

/// Appends the same contacts as `self_collide` with `tracker.filter()`, in the same order.
///
/// Preconditions:
/// `tracker`: of the model of `pose`. Otherwise the program aborts, in every build. Not used by
/// another thread at the same time.
/// `scratch`: as in `self_collide`.
///
/// Cost: as `self_collide`, but triangles are tested only where the surface has moved, since their
/// last test, by more than their distance, apart from the motion of a joint. The first call, and
/// calls after a large change of the pose, cost more than `self_collide`.
///
/// Allocates only in the pose, in `scratch` and in `contacts`, as `self_collide` does.
PELT_API SelfStats self_collide(Pose& pose, SelfTracker& tracker, Scratch& scratch,
                                std::vector<Contact>& contacts, const CollideOptions& options = {});

}  // namespace pelt
