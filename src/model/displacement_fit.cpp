#include "model/displacement_fit.hpp"

#include "model/intervals.hpp"
#include "model/unpack.hpp"

#include <algorithm>
#include <tuple>

namespace pelt::detail {

DisplacementFit::DisplacementFit(const Tree& tree)
    : vertices_(unpack_vertices(tree)), numbers_(tree.joint_count) {}

void DisplacementFit::add(const NodeBounds& bounds, const NodeBound& bound,
                          std::span<const std::uint32_t> places) {
  joint_boxes_.resize(bounds.joint_boxes.size());
  shapes_.resize(bounds.shapes.size());
  displaced_.clear();
  vertex_counts_.assign(bound.is_affine() ? 1 : bound.joint_count, 0);
  if (bound.is_affine()) {
    for (const std::uint32_t place : places) gather(0, place);
    box_all(shapes_, bound.shape);
    return;
  }
  for (std::uint32_t i = 0; i < bound.joint_count; ++i)
    numbers_[bounds.joints[bound.first_joint + i]] = i;
  for (const std::uint32_t place : places)
    for (const Influence& influence : vertices_.influences_of(place))
      gather(numbers_[influence.joint], place);
  box_all(joint_boxes_, bound.first_record);
}

void DisplacementFit::gather(std::uint32_t body, std::uint32_t place) {
  ++vertex_counts_[body];
  for (const Displacement& displacement : vertices_.displacements_of(place))
    displaced_.push_back({body, displacement});
}

/// `first` is the number of the set's first body among all bodies of its kind.
void DisplacementFit::box_all(std::vector<Boxes>& bodies, std::size_t first) {
  const auto key = [](const Displaced& d) { return std::tuple(d.body, d.displacement.target); };
  std::sort(displaced_.begin(), displaced_.end(),
            [&](const Displaced& a, const Displaced& b) { return key(a) < key(b); });
  for (auto run = displaced_.begin(); run != displaced_.end();) {
    const auto end = std::find_if(run, displaced_.end(),
                                  [&](const Displaced& other) { return key(other) != key(*run); });
    bodies[first + run->body].push_back(box_of({&*run, static_cast<std::size_t>(end - run)}));
    run = end;
  }
}

DisplacementBox DisplacementFit::box_of(std::span<const Displaced> of_one_target) const {
  Intervals3 extents;
  for (const Displaced& displaced : of_one_target)
    extents.include(Vec3d(displaced.displacement.by));
  const bool some_stay = of_one_target.size() < vertex_counts_[of_one_target[0].body];
  if (some_stay) extents.include(Vec3d());
  DisplacementBox box;
  box.target = of_one_target[0].displacement.target;
  extents.store(box.centre, box.half);
  return box;
}

void DisplacementFit::finish(NodeBounds& bounds) const {
  bounds.displacement_begin.reserve(joint_boxes_.size() + shapes_.size() + 1);
  bounds.displacement_begin.push_back(0);
  for (const auto* bodies : {&joint_boxes_, &shapes_})
    for (const Boxes& boxes : *bodies) {
      bounds.displacements.insert(bounds.displacements.end(), boxes.begin(), boxes.end());
      bounds.displacement_begin.push_back(static_cast<std::uint32_t>(bounds.displacements.size()));
    }
  bounds.displacements.shrink_to_fit();
}

}  // namespace pelt::detail
