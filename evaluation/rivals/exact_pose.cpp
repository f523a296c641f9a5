#include "evaluation/rivals/exact_pose.hpp"

#include "base/wide_code.hpp"
#include "collide/sort_contacts.hpp"

#include <limits>

namespace pelt::rivals {

ExactPose::ExactPose(const detail::Tree& tree) : tree_(tree), palette_(rest_palette(tree)) {
  close_all();
}

Result<void> ExactPose::set_morph_weights(std::span<const float> weights) {
  return palette_.set_morph_weights(weights);
}

Result<void> ExactPose::set_palette(std::span<const Matrix4> palette) {
  Result<void> taken = palette_.set(palette);
  if (taken) close_all();
  return taken;
}

void ExactPose::close_all() {
  arena_.clear();
  root_box_.known = false;
  opened_ = detail::OpenedNodes(static_cast<std::uint32_t>(tree_.nodes.size()), arena_);
}

QueryStats ExactPose::open_all() { return detail::wide_code().open_all_exactly(posed_tree()); }

detail::PosedTree ExactPose::posed_tree() {
  return {tree_, no_bounds_, palette_, root_box_, opened_, arena_};
}

QueryStats collide(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                   std::vector<Contact>& contacts, const CollideOptions& options) {
  const QueryStats work = detail::wide_code().collide_trees(a.posed_tree(), b.posed_tree(), scratch,
                                                            options.max_contacts);
  detail::sort_contacts(scratch.found, scratch.sorting);
  contacts.insert(contacts.end(), scratch.found.begin(), scratch.found.end());
  return work;
}

QueryStats distance(ExactPose& a, ExactPose& b, detail::Scratch& scratch,
                    detail::TriangleGap& nearest) {
  const detail::SearchLimits limits = {std::numeric_limits<double>::infinity(), 0, nullptr};
  return detail::wide_code().nearest_triangles(a.posed_tree(), b.posed_tree(), scratch, limits,
                                               nearest);
}

}  // namespace pelt::rivals
