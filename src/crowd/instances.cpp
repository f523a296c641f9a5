#include "crowd/instances.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "pose/root_box.hpp"

namespace pelt::detail {
namespace {

void take_box(CrowdInstance& instance) {
  instance.root_box = box_root(instance.model.detail().bounds, instance.palette);
  instance.has_moved = true;
}

/// Computes the box at once, because the palette is in the caches now, and because this runs on all
/// threads on which the caller sets palettes.
template <typename Element>
Result<void> set_palette_of(CrowdInstance& instance, std::span<const Element> palette) {
  Result<void> set = instance.palette.set(palette);
  if (set) take_box(instance);
  return set;
}

}  // namespace

/// A free number is used only after its instance exists, so that an allocation failure changes
/// nothing.
std::uint32_t CrowdInstances::add(const SkinnedModel& model, const CollisionMask& mask) {
  if (free_.empty()) add_slot();
  const std::uint32_t number = free_.back();
  take_box(slots_[number].emplace(model, mask));
  free_.pop_back();
  ++count_;
  return number;
}

/// Reserves memory for all numbers to be free at once, so that `remove` never allocates.
void CrowdInstances::add_slot() {
  if (free_.capacity() == slots_.size()) free_.reserve(2 * slots_.size() + 1);
  slots_.emplace_back();
  free_.push_back(end() - 1);
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

Result<void> CrowdInstances::set_palette(std::uint32_t number, std::span<const float> palette) {
  return set_palette_of((*this)[number], palette);
}

Result<void> CrowdInstances::set_palette(std::uint32_t number, std::span<const Matrix3x4> palette) {
  return set_palette_of((*this)[number], palette);
}

Result<void> CrowdInstances::set_palette(std::uint32_t number, std::span<const double> palette) {
  return set_palette_of((*this)[number], palette);
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
