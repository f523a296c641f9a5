#include "tools/pelt/check/frame_query.hpp"

#include <pelt/distance.hpp>
#include <pelt/search.hpp>
#include <pelt/self.hpp>

#include "text/message.hpp"
#include "tools/pelt/check/frame_line.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

namespace pelt::tools::check {
namespace {

using Clock = std::chrono::steady_clock;
using Body = scenes::IgnoredPairs::Body;

Body body_of(const scene::StagedScene& staged, std::uint32_t collider) {
  const scene::Collider& body = staged.colliders[collider];
  return {staged.character_of(collider), body.first_triangle, body.model.triangle_count()};
}

/// Removes ignored contacts. Returns the number of removed contacts.
std::uint64_t take_ignored_out(const Stage& stage, scene::FrameContacts& found) {
  if (stage.ignored->is_empty()) return 0;
  const std::size_t before = found.contacts.size();
  found.keep([&](const scene::FrameContacts::Pair& pair, std::span<Contact> contacts) {
    return stage.ignored->keep_counted(stage.staged.character_of(pair.a),
                                       stage.staged.character_of(pair.b), contacts);
  });
  return before - found.contacts.size();
}

/// Whether a crowd cannot answer what is asked. A crowd tests colliders against themselves first,
/// and with all nodes opened, a limit ends a query of a pair at other contacts.
bool needs_poses(const Stage& stage) {
  const CheckOptions& options = stage.settings.options;
  return options.inside || options.contacts || options.clearance || options.budget ||
         (stage.settings.max_contacts && stage.filters);
}

/// Models of parts number only the joints that the part follows.
void number_joints_in_assets(ContactGeometry& geometry, const scene::Collider& a,
                             const scene::Collider& b) {
  const auto renumber = [&](auto& described) {
    described.joint_a = a.joint_in_asset(described.joint_a);
    described.joint_b = b.joint_in_asset(described.joint_b);
  };
  for (ContactTrace& trace : geometry.traces) renumber(trace);
  for (ContactPatch& patch : geometry.patches) renumber(patch);
}

}  // namespace

FrameQuery::FrameQuery(const Stage& stage, std::uint32_t threads)
    : stage_(stage), own_(stage.colliders.size()) {
  const CheckSettings& settings = stage.settings;
  const bool by_poses = needs_poses(stage);
  if (by_poses) posed_.emplace(stage.colliders);
  if (settings.method != methods::kOnDemand)
    contacts_.emplace(stage.colliders, settings.method.make());
  else if (!by_poses)
    contacts_ = scene::SceneQuery::as_crowd(stage.colliders, threads,
                                            {settings.self.asks_pairs(), stage.filters});
  if (settings.substeps) steps_.emplace(stage, threads);
}

Result<void> FrameQuery::ask(std::size_t index, FrameAnswer& answer) {
  if (const auto asked = ask_frame(index, answer); !asked)
    return text::prefixed(scene::frame_words(stage_.staged.scene, stage_.frames[index]),
                          asked.error());
  return {};
}

Result<void> FrameQuery::ask_frame(std::size_t index, FrameAnswer& answer) {
  answer.frame = stage_.frames[index];
  scene::sample_palettes(stage_.staged.scene, answer.frame, sample_scratch_, palettes_);
  const QueryStats before = contacts_ ? contacts_->work() : QueryStats{};
  work_ = {};
  if (const auto found = find_contacts(answer); !found) return found;
  ask_inside(answer);
  answer.ignored = take_ignored_out(stage_, answer.found);
  describe(answer);
  answer.work = contacts_ ? scene::work_between(before, contacts_->work()) : QueryStats{};
  answer.work += work_;
  return ask_step(index, answer);
}

/// Finds the contacts of the frame, including ignored ones.
Result<void> FrameQuery::find_contacts(FrameAnswer& answer) {
  Limits limits;
  if (stage_.settings.max_contacts) limits.max_contacts = *stage_.settings.max_contacts;
  const Clock::time_point begin = Clock::now();
  if (posed_)
    if (const auto posed = posed_->set_palettes(palettes_); !posed) return posed;
  if (contacts_) {
    if (const auto posed = contacts_->set_palettes(palettes_); !posed) return posed;
    contacts_->collide(limits, answer.found);
    answer.left_out = contacts_->left_out();
    touching_ = answer.found.pairs;
  } else {
    find_by_poses(limits, answer);
  }
  answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return {};
}

/// Without a limit, tests colliders against themselves first, because this opens all nodes at once.
void FrameQuery::find_by_poses(const Limits& limits, FrameAnswer& answer) {
  answer.undecided.clear();
  answer.left_out = {};
  const bool is_limited = stage_.settings.max_contacts.has_value();
  if (stage_.filters && !is_limited) find_own(limits, answer);
  find_pairs(limits, answer);
  if (stage_.filters && is_limited) find_own(limits, answer);
  answer.found.clear();
  auto pair = pairs_.pairs.begin();
  for (std::uint32_t c = 0; c < stage_.colliders.size(); ++c) {
    for (const Contact& contact : own_[c]) answer.found.add(c, c, contact);
    for (; pair != pairs_.pairs.end() && pair->a == c; ++pair)
      for (const Contact& contact : pairs_.of(*pair)) answer.found.add(c, pair->b, contact);
  }
  touching_ = pairs_.pairs;
  if (stage_.filters)
    answer.left_out +=
        stage_.filters->leave_out_between_parts(stage_.colliders, limits, scratch_, answer.found);
}

void FrameQuery::find_own(const Limits& limits, FrameAnswer& answer) {
  for (std::uint32_t c = 0; c < stage_.colliders.size(); ++c) {
    const scene::Collider& collider = stage_.colliders[c];
    own_[c].clear();
    const SelfStats stats = self_collide(posed_->poses()[c], stage_.filters->of_colliders[c],
                                         scratch_, own_[c], limits);
    for (Contact& contact : own_[c])
      contact = scene::numbered_in_assets(contact, collider, collider);
    work_ += stats;
    answer.left_out += stats.left_out;
  }
}

void FrameQuery::find_pairs(const Limits& limits, FrameAnswer& answer) {
  pairs_.clear();
  near_ = near_pairs_.find(posed_->poses(), stage_.settings.options.clearance.value_or(0));
  if (!stage_.settings.self.asks_pairs()) return;
  const bool needs_all = stage_.filters && stage_.filters->need_all_of_pairs();
  for (const CrowdPair& pair : near_) {
    const auto [a, b] = pair;
    find_of_pair(pair, needs_all ? Limits{} : limits, answer);
    for (const Contact& contact : found_)
      pairs_.add(a, b,
                 scene::numbered_in_assets(contact, stage_.colliders[a], stage_.colliders[b]));
  }
}

/// Finds the contacts of a pair, numbered as in the models.
void FrameQuery::find_of_pair(const CrowdPair& pair, const Limits& limits, FrameAnswer& answer) {
  const CheckOptions& asked = stage_.settings.options;
  Pose &a = posed_->poses()[pair.instance_a], &b = posed_->poses()[pair.instance_b];
  found_.clear();
  if (asked.clearance) {
    work_ += clearance(a, b, *asked.clearance, scratch_, found_, limits);
  } else if (asked.budget) {
    search(a, b, pair, answer);
  } else {
    work_ += collide(a, b, scratch_, found_, limits);
  }
}

/// Finds the contacts that the budget suffices for.
void FrameQuery::search(Pose& a, Pose& b, const CrowdPair& pair, FrameAnswer& answer) {
  CollisionSearch search(a, b, SearchOrder::resolution);
  work_ += search.advance(*stage_.settings.options.budget, scratch_);
  if (!search.is_complete())
    answer.undecided.push_back({pair.instance_a, pair.instance_b, search.verdict(),
                                search.undecided_pairs(), search.resolution(),
                                search.distance_bound()});
  found_.assign(search.contacts().begin(), search.contacts().end());
  std::sort(found_.begin(), found_.end());
}

/// Computes the depth of touching pairs, and whether one body of the other pairs contains the
/// other. Leaves out touching pairs without a vertex inside, and pairs whose triangles are all
/// ignored.
void FrameQuery::ask_inside(FrameAnswer& answer) {
  if (!stage_.settings.options.inside) return;
  answer.inside.clear();
  if (contacts_) near_ = near_pairs_.find(posed_->poses(), 0);
  auto touching = touching_.begin();
  for (const CrowdPair& near : near_) {
    while (touching != touching_.end() && touching->a == touching->b) ++touching;
    const bool touches = touching != touching_.end() && touching->a == near.instance_a &&
                         touching->b == near.instance_b;
    if (touches) ++touching;
    if (is_ignored(near)) continue;
    const InsidePair pair = inside_of(near, touches);
    if (pair.containment != Containment::none || pair.a_in_b || pair.b_in_a)
      answer.inside.push_back(pair);
  }
}

InsidePair FrameQuery::inside_of(const CrowdPair& near, bool touches) {
  const auto [a, b] = near;
  InsidePair pair = {.a = a, .b = b};
  if (touches) {
    pair.a_in_b = deepest(a, b);
    pair.b_in_a = deepest(b, a);
  } else {
    const std::span<Pose> poses = posed_->poses();
    work_ += containment(poses[a], poses[b], scratch_, pair.containment);
  }
  return pair;
}

/// The deepest vertex of `a` in `b`.
Penetration FrameQuery::deepest(std::uint32_t a, std::uint32_t b) {
  Penetration found;
  if (!stage_.colliders[b].model.surface().is_closed()) return found;
  const std::span<Pose> poses = posed_->poses();
  work_ += deepest_vertex(poses[a], poses[b], scratch_, found);
  return found;
}

/// Cached by character, because all instances of a character have the same answer.
bool FrameQuery::is_ignored(const CrowdPair& pair) {
  if (stage_.ignored->is_empty()) return false;
  const Bodies bodies = {body_of(stage_.staged, pair.instance_a),
                         body_of(stage_.staged, pair.instance_b)};
  const auto [known, is_new] = are_ignored_.try_emplace(bodies);
  if (is_new) known->second = stage_.ignored->are_ignored(bodies.first, bodies.second);
  return known->second;
}

/// The work does not include that of describing.
void FrameQuery::describe(FrameAnswer& answer) {
  if (!stage_.settings.options.contacts) return;
  answer.patches.clear();
  described_ = answer.found.pairs.size();
  geometry_.resize(std::max(geometry_.size(), described_));
  for (std::size_t i = 0; i < described_; ++i) {
    const std::uint32_t a = answer.found.pairs[i].a, b = answer.found.pairs[i].b;
    const scene::Collider &of_a = stage_.colliders[a], &of_b = stage_.colliders[b];
    const std::span<Pose> poses = posed_->poses();
    found_.clear();
    for (const Contact& contact : answer.found.of(answer.found.pairs[i]))
      found_.push_back(scene::numbered_in_models(contact, of_a, of_b));
    if (a == b)
      describe_contacts(poses[a], found_, scratch_, geometry_[i]);
    else
      describe_contacts(poses[a], poses[b], found_, scratch_, geometry_[i]);
    number_joints_in_assets(geometry_[i], of_a, of_b);
    for (const ContactPatch& patch : geometry_[i].patches)
      answer.patches.push_back({a, b, patch.joint_a, patch.joint_b, patch.length});
  }
}

Result<void> FrameQuery::ask_step(std::size_t index, FrameAnswer& answer) {
  answer.step.reset();
  const std::optional<std::uint32_t> from = stage_.step_from(index);
  if (!from) return {};
  return steps_->ask(*from, answer.frame, palettes_, answer.step.emplace());
}

Result<void> ask_frames(const Stage& stage, const Indices& indices, bool writes_lines,
                        const UseAnswer& use) {
  const std::uint32_t threads =
      detail::Workers::count_or_available(stage.settings.options.threads.value_or(0));
  std::vector<std::unique_ptr<FrameQuery>> queries(threads);  // each made by its own thread
  const auto ask = [&](const ItemWorker& worker, std::size_t index, FrameAnswer& answer) {
    std::unique_ptr<FrameQuery>& query = queries[worker.number];
    if (!query) query = std::make_unique<FrameQuery>(stage, worker.threads);
    Result<void> asked = query->ask(index, answer);
    if (asked && writes_lines) answer.line = frame_line(stage, answer, query->geometry());
    return asked;
  };
  return compute_in_order<FrameAnswer>(indices, threads, ask, use);
}

}  // namespace pelt::tools::check
