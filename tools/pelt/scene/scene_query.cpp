#include "tools/pelt/scene/scene_query.hpp"

#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>
#include <atomic>

namespace pelt::tools::scene {
namespace {

/// Setting fewer palettes than this takes less time than waking a thread.
constexpr std::size_t kPalettesWorthAThread = 64;

}  // namespace

SceneQuery::SceneQuery(std::span<const Collider> colliders, const methods::MethodKind& method)
    : SceneQuery(colliders) {
  if (method == methods::kOnDemand) {
    make_crowd(0);
  } else {
    method_ = method.make();
    for (const Collider& collider : colliders_) method_->add(collider.model);
  }
}

SceneQuery::SceneQuery(std::span<const Collider> colliders, std::unique_ptr<methods::Method> method)
    : SceneQuery(colliders) {
  method_ = std::move(method);
  for (const Collider& collider : colliders_) method_->add(collider.model);
}

SceneQuery SceneQuery::of_each(std::span<const Collider> colliders,
                               std::unique_ptr<methods::Method> method) {
  SceneQuery query(colliders, std::move(method));
  query.of_each_ = true;
  return query;
}

SceneQuery SceneQuery::as_crowd(std::span<const Collider> colliders, std::uint32_t threads,
                                SelfTests tests) {
  SceneQuery query(colliders);
  query.tests_ = std::move(tests);
  query.make_crowd(threads);
  return query;
}

void SceneQuery::make_crowd(std::uint32_t threads) {
  thread_count_ = detail::Workers::count_or_available(threads);
  threads_ = std::make_unique<detail::Workers>();
  crowd_.emplace();
  for (const Collider& collider : colliders_) crowd_->add(collider.model);
}

Result<void> SceneQuery::set_palettes(const Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  if (crowd_ && set_on_threads(palettes)) return {};
  InputSelection selection;
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    const auto posed = set_pose_of(c, selection.select(palettes, colliders_[c]));
    if (!posed) return in_instance(colliders_[c].instance, posed.error());
  }
  return {};
}

/// Returns false if there are too few palettes, or if one was rejected.
bool SceneQuery::set_on_threads(const Palettes& palettes) {
  const auto count = static_cast<std::uint32_t>(
      std::min<std::size_t>(thread_count_, colliders_.size() / kPalettesWorthAThread));
  if (count < 2) return false;
  std::atomic<bool> all_taken = true;
  shares_.deal(static_cast<std::uint32_t>(colliders_.size()), count);
  threads_->run(count, [&](std::uint32_t thread) {
    InputSelection selection;
    while (const auto c = shares_.take(thread))
      if (!set_pose_of(*c, selection.select(palettes, colliders_[*c]))) all_taken = false;
  });
  return all_taken;
}

Result<void> SceneQuery::set_pose_of(std::uint32_t collider, const PoseInputs& inputs) {
  return crowd_ ? set_pose(inputs, *crowd_, collider) : set_pose(inputs, *method_, collider);
}

void SceneQuery::collide(const Limits& limits, FrameContacts& found) {
  found.clear();
  if (crowd_) return collide_crowd(limits, found);
  for (std::uint32_t a = 0; a < colliders_.size(); ++a) {
    if (of_each_) {
      collide_pair(a, a, limits, found);
      continue;
    }
    for (std::uint32_t b = a + 1; b < colliders_.size(); ++b) collide_pair(a, b, limits, found);
  }
}

CrowdOptions SceneQuery::crowd_options(const Limits& limits) const {
  CrowdOptions of_crowd = tests_.crowd_options();
  of_crowd.threads = thread_count_;
  of_crowd.max_contacts = limits.max_contacts;
  return of_crowd;
}

void SceneQuery::collide_crowd(const Limits& limits, FrameContacts& found) {
  crowd_contacts_.clear();
  const CrowdStats stats = crowd_->collide(crowd_contacts_, crowd_options(limits));
  query_work_ += stats;
  left_out_ = stats.left_out;
  for (const auto& [a, b, triangle_a, triangle_b] : crowd_contacts_)
    found.add(a, b, numbered_in_assets({triangle_a, triangle_b}, colliders_[a], colliders_[b]));
  if (tests_.filters)
    left_out_ += tests_.filters->leave_out_between_parts(colliders_, limits, scratch_, found);
}

void SceneQuery::collide_pair(std::uint32_t a, std::uint32_t b, const Limits& limits,
                              FrameContacts& found) {
  const std::size_t begin = found.contacts.size();
  query_work_ += method_->collide(a, b, found.contacts, limits);
  const std::size_t end = found.contacts.size();
  for (std::size_t i = begin; i < end; ++i)
    found.contacts[i] = numbered_in_assets(found.contacts[i], colliders_[a], colliders_[b]);
  if (end > begin) found.pairs.push_back({a, b, begin, end});
}

QueryStats SceneQuery::work() const {
  QueryStats work = query_work_;
  if (method_) work += method_->update_work();
  return work;
}

QueryStats work_between(const QueryStats& before, const QueryStats& after) {
  QueryStats work;
  work.node_pairs = after.node_pairs - before.node_pairs;
  work.refits = after.refits - before.refits;
  work.posed_vertices = after.posed_vertices - before.posed_vertices;
  work.triangle_pairs = after.triangle_pairs - before.triangle_pairs;
  work.displacements = after.displacements - before.displacements;
  return work;
}

}  // namespace pelt::tools::scene
