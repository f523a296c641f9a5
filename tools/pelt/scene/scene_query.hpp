#pragma once

/// Finds the contacts of one frame of a scene: samples palettes, poses bodies, and queries every
/// pair.

#include <pelt/crowd.hpp>

#include "base/workers.hpp"
#include "tools/pelt/methods/method.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"
#include "tools/pelt/scene/self_filters.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pelt::tools::scene {

class SceneQuery {
 public:
  /// `colliders` must outlive the query. The method on_demand queries them as a crowd on all cores,
  /// other methods pair by pair.
  SceneQuery(std::span<const Collider> colliders, const methods::MethodKind& method);

  /// Queries pair by pair.
  SceneQuery(std::span<const Collider> colliders, std::unique_ptr<methods::Method> method);

  /// Queries each collider against itself.
  static SceneQuery of_each(std::span<const Collider> colliders,
                            std::unique_ptr<methods::Method> method);

  /// Queries `tests` as a crowd on this number of threads; 0 means all cores.
  static SceneQuery as_crowd(std::span<const Collider> colliders, std::uint32_t threads,
                             SelfTests tests = {});

  /// Poses all colliders; a crowd uses its threads if there are enough colliders. Error messages
  /// name the instance.
  Result<void> set_palettes(const Palettes& palettes);

  /// See methods::Method::update_counts.
  bool update_counts() const { return crowd_ || method_->update_counts(); }

  /// Replaces `found` by the contacts of every pair of colliders, or of each with itself.
  ///
  /// Precondition: there is no limit if parts of one instance are filtered, because the filters may
  /// drop any contacts.
  void collide(const Limits& limits, FrameContacts& found);

  /// Number of contacts that each filter has left out of the latest frame.
  const LeftOut& left_out() const { return left_out_; }

  /// The work of posing and querying so far.
  QueryStats work() const;

 private:
  explicit SceneQuery(std::span<const Collider> colliders)
      : colliders_(colliders), parted_(colliders) {}

  void make_crowd(std::uint32_t threads);
  CrowdOptions crowd_options(const Limits& limits) const;
  bool set_on_threads(const Palettes& palettes);
  Result<void> set_pose_of(std::uint32_t collider, const PoseInputs& inputs);
  void collide_crowd(const Limits& limits, FrameContacts& found);
  void collide_pair(std::uint32_t a, std::uint32_t b, const Limits& limits, FrameContacts& found);

  std::span<const Collider> colliders_;
  PartedInstances parted_;
  std::optional<Crowd> crowd_;  // with the members up to its contacts; otherwise `method_`
  std::uint32_t thread_count_ = 1;
  std::unique_ptr<detail::Workers> threads_;
  detail::WorkShares shares_;  // of the palettes
  SelfTests tests_;            // of the crowd
  Scratch scratch_;            // of the filters of parts
  LeftOut left_out_;
  std::vector<CrowdContact> crowd_contacts_;
  std::unique_ptr<methods::Method> method_;
  bool of_each_ = false;  // with `method_` only
  QueryStats query_work_;
};

/// The work between two sums. `cut_short` of the result is always false.
QueryStats work_between(const QueryStats& before, const QueryStats& after);

}  // namespace pelt::tools::scene
