#include "crowd/instances.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "base/wide_code.hpp"

namespace pelt::detail {
namespace {

void take_box(CrowdInstance& instance) {
  instance.root_box = wide_code().box_root(instance.model.detail().bounds, instance.palette);
  instance.has_moved = true;
}

}  // namespace

std::uint32_t CrowdInstances::add(const SkinnedModel& model, const CrowdGroups& groups) {
  if (free_.empty()) {
    free_.push_back(end());
    slots_.emplace_back();
  }
  const std::uint32_t number = free_.back();
  free_.pop_back();
  take_box(slots_[number].emplace(model, groups));
  ++count_;
  return number;
}

void CrowdInstances::remove(std::uint32_t number) {
  PELT_ASSERT(number < end() && has(number));
  slots_[number].reset();
  free_.push_back(number);
  --count_;
}

CrowdInstance& CrowdInstances::operator[](std::uint32_t number) {
  PELT_ASSERT(number < end() && has(number));
  return *slots_[number];
}

/// The box is taken at once because the palette is in the caches now, and because that is done by
/// as many threads as the caller sets palettes on.
Result<void> CrowdInstances::set_palette(std::uint32_t number, std::span<const float> palette) {
  CrowdInstance& instance = (*this)[number];
  Result<void> taken = instance.palette.set(palette);
  if (taken) take_box(instance);
  return taken;
}

Result<void> CrowdInstances::set_morph_weights(std::uint32_t number,
                                               std::span<const float> weights) {
  CrowdInstance& instance = (*this)[number];
  Result<void> taken = instance.palette.set_morph_weights(weights);
  if (taken) take_box(instance);
  return taken;
}

std::size_t CrowdInstances::memory_bytes() const {
  std::size_t bytes = bytes_held(slots_, free_);
  for (const std::optional<CrowdInstance>& slot : slots_)
    if (slot) bytes += slot->palette.memory_bytes();
  return bytes;
}

}  // namespace pelt::detail
