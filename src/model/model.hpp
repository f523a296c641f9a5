#pragma once

/// The data of a model.

#include <pelt/model.hpp>

#include "model/node_bounds.hpp"
#include "model/tree.hpp"

#include <memory>
#include <mutex>

namespace pelt::detail {

/// A value that the first call of `get` makes, once, also if several threads call it. A copy starts
/// without a value. If making it throws, the next call tries again.
template <typename T>
class MadeOnce {
 public:
  MadeOnce() = default;
  MadeOnce(const MadeOnce&) noexcept {}
  MadeOnce& operator=(const MadeOnce&) = delete;

  /// `make` returns a std::shared_ptr<const T>, whose deleter is known where T is complete.
  template <typename Make>
  const T& get(const Make& make) const {
    std::call_once(is_made_, [&] { value_ = make(); });
    return *value_;
  }

 private:
  mutable std::once_flag is_made_;
  mutable std::shared_ptr<const T> value_;
};

struct Surface;

/// The data that copies of a SkinnedModel share.
struct Model {
  Tree tree;
  NodeBounds bounds;
  BuildReport report;
  MadeOnce<Surface> lazy_surface;

  /// See SkinnedModel::surface. Precondition: the model stays where it is.
  const Surface& surface() const;
};

/// Calls `visit(array)` for each array of a model, in the order of a prepared file.
template <typename AnyModel, typename Visit>
void each_array(AnyModel& model, Visit&& visit) {
  visit(model.tree.rest_positions);
  visit(model.tree.influence_begin);
  visit(model.tree.joints);
  visit(model.tree.weights);
  visit(model.tree.corners);
  visit(model.tree.triangle_ids);
  visit(model.tree.cluster_vertices);
  visit(model.tree.clusters);
  visit(model.tree.nodes);
  visit(model.tree.vertex_places);
  visit(model.tree.place_vertices);
  visit(model.tree.offset_caps);
  visit(model.tree.morphs.extents);
  visit(model.tree.morphs.node_begin);
  visit(model.tree.morphs.targets);
  visit(model.tree.morphs.displacements);
  visit(model.tree.links);
  visit(model.bounds.nodes);
  visit(model.bounds.joints);
  visit(model.bounds.joint_boxes);
  visit(model.bounds.shapes);
  visit(model.bounds.fits);
  visit(model.bounds.displacement_begin);
  visit(model.bounds.displacements);
  visit(model.bounds.dual_bounds);
  visit(model.bounds.joint_pairs);
}

}  // namespace pelt::detail
