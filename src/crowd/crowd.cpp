/// The functions of pelt::Crowd.

#include <pelt/crowd.hpp>

#include "crowd/crowd_query.hpp"
#include "crowd/crowd_search.hpp"
#include "crowd/instances.hpp"
#include "query/answers.hpp"

namespace pelt {
namespace detail {

struct Crowd {
  CrowdInstances instances;
  CrowdQuery query;
  CrowdSearch search;
};

}  // namespace detail

Crowd::Crowd() : crowd_(std::make_unique<detail::Crowd>()) {}
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;
Crowd::~Crowd() = default;

std::uint32_t Crowd::add(const SkinnedModel& model, const CollisionMask& mask) {
  return crowd_->instances.add(model, mask);
}

void Crowd::remove(std::uint32_t instance) { crowd_->instances.remove(instance); }

std::uint32_t Crowd::size() const { return crowd_->instances.count(); }

const SkinnedModel& Crowd::model(std::uint32_t instance) const {
  return crowd_->instances[instance].model;
}

void Crowd::set_collision_mask(std::uint32_t instance, const CollisionMask& mask) {
  crowd_->instances[instance].mask = mask;
}

Result<void> Crowd::set_palette(std::uint32_t instance, const JointMatrices& palette) {
  return crowd_->instances.set_palette(instance, palette);
}

Result<void> Crowd::set_dual_quaternions(std::uint32_t instance,
                                         std::span<const float> dual_quaternions) {
  return crowd_->instances.set_dual_quaternions(instance, dual_quaternions);
}

Result<void> Crowd::set_morph_weights(std::uint32_t instance, std::span<const float> weights) {
  return crowd_->instances.set_morph_weights(instance, weights);
}

Result<void> Crowd::set_vertices(std::uint32_t instance, std::span<const Vec3> vertices) {
  return crowd_->instances.set_vertices(instance, vertices);
}

Result<void> Crowd::set_offsets(std::uint32_t instance, std::span<const Vec3> offsets) {
  return crowd_->instances.set_offsets(instance, offsets);
}

void Crowd::begin_step() { crowd_->instances.begin_step(); }

Result<void> Crowd::set_motion(std::uint32_t instance, const JointMatrices& from,
                               const JointMatrices& to) {
  return crowd_->instances.set_motion(instance, from, to);
}

Result<void> Crowd::set_motion_dual_quaternions(std::uint32_t instance, std::span<const float> from,
                                                std::span<const float> to) {
  return crowd_->instances.set_motion_dual_quaternions(instance, from, to);
}

CrowdStats Crowd::collide(std::vector<CrowdContact>& contacts, const CrowdOptions& options) {
  const CrowdStats stats = crowd_->query.run(crowd_->instances, options, options.max_contacts);
  std::size_t end = contacts.size(), count = 0;
  for (const detail::TouchingPair& pair : crowd_->query.touching()) count += pair.contacts.size();
  contacts.resize(end + count);
  for (const detail::TouchingPair& pair : crowd_->query.touching())
    for (const Contact& contact : pair.contacts)
      contacts[end++] = {pair.instances.instance_a, pair.instances.instance_b, contact.triangle_a,
                         contact.triangle_b};
  return stats;
}

CrowdStats Crowd::intersecting_pairs(std::vector<CrowdPair>& pairs, const CrowdOptions& options) {
  CrowdStats stats = crowd_->query.run(crowd_->instances, options, 1);
  const std::span<const detail::TouchingPair> touching = crowd_->query.touching();
  std::size_t end = pairs.size();
  pairs.resize(end + touching.size());
  for (const detail::TouchingPair& pair : touching) pairs[end++] = pair.instances;
  stats.cut_short = false;
  return stats;
}

CrowdStats Crowd::collide(std::vector<CrowdMovingContact>& contacts, const CrowdOptions& options,
                          const MovingOptions& moving) {
  const CrowdStats stats = crowd_->query.run_moving(crowd_->instances, options, moving);
  std::size_t end = contacts.size(), count = 0;
  for (const detail::TouchingPair& pair : crowd_->query.touching()) count += pair.moving.size();
  contacts.resize(end + count);
  for (const detail::TouchingPair& pair : crowd_->query.touching())
    for (const MovingContact& contact : pair.moving)
      contacts[end++] = {pair.instances.instance_a, pair.instances.instance_b, contact};
  return stats;
}

CrowdStats Crowd::search(std::vector<CrowdContact>& contacts, std::vector<UndecidedPair>& undecided,
                         const CrowdBudget& budget, const CrowdOptions& options) {
  CrowdStats stats;
  const std::span<const CrowdPair> pairs =
      crowd_->query.find_pairs(crowd_->instances, options, stats);
  const std::uint64_t moved = stats.refits;
  stats = crowd_->search.run(crowd_->instances, pairs, budget, options.threads);
  stats.refits += moved;
  detail::reserve_more(undecided, pairs.size());
  crowd_->search.append_contacts(contacts);
  crowd_->search.append_undecided(crowd_->instances, undecided);
  return stats;
}

std::size_t Crowd::memory_bytes() const {
  return crowd_->instances.memory_bytes() + crowd_->query.memory_bytes() +
         crowd_->search.memory_bytes();
}

}  // namespace pelt
