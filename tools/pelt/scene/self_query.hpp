#pragma once

/// Finds the contacts of each collider with itself in one frame of a scene, and filters those of
/// the parts of an instance.

#include <pelt/self.hpp>

#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/self_filters.hpp"

#include <memory>
#include <span>
#include <vector>

namespace pelt::tools::scene {

class SelfQuery {
 public:
  /// `colliders` must outlive the query. `threads`: 0 means all cores.
  SelfQuery(std::span<const Collider> colliders, SelfFilters filters, std::uint32_t threads = 0);

  /// Error messages name the instance.
  Result<void> set_palettes(const Palettes& palettes) { return posed_.set_palettes(palettes); }

  /// The limit of the query of pairs whose contacts `collide` filters. Filters may drop any
  /// contacts, so that all are needed.
  Limits limit_of_pairs(const Limits& limits) const {
    return filters_.of_parts.empty() ? limits : Limits{};
  }

  /// Removes from `found` the contacts of parts of one instance that its filter drops, and those
  /// beyond the limit of each pair. Then adds the contacts of each collider with itself, as those
  /// of the pair a, a.
  void collide(const Limits& limits, FrameContacts& found);

  const SelfFilters& filters() const { return filters_; }

  /// Number of contacts that each filter has left out of the latest frame.
  const LeftOut& left_out() const { return left_out_; }

  /// The work so far.
  QueryStats work() const { return work_; }

 private:
  /// Results of one collider.
  struct Own {
    std::vector<Contact> contacts;
    SelfStats stats;
  };

  void filter_parts(const Limits& limits, FrameContacts& found);
  void filter_parts_of(std::uint32_t instance, std::vector<Contact>& contacts);
  void find(const Limits& limits);
  void find_of(std::uint32_t collider, const Limits& limits, Scratch& scratch);

  std::span<const Collider> colliders_;
  SelfFilters filters_;
  std::vector<std::size_t> filter_of_instance_;  // index into `filters_.of_parts`
  ScenePoses posed_;
  std::unique_ptr<detail::Workers> workers_;
  detail::WorkShares shares_;       // of the colliders
  std::vector<Scratch> scratches_;  // of each worker
  std::vector<Own> own_;            // of each collider
  FrameContacts merged_;            // working memory of `collide`
  std::vector<Contact> kept_;       // of `filter_parts`
  LeftOut left_out_;
  QueryStats work_;
};

}  // namespace pelt::tools::scene
