#include "crowd/instances.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "pose/pose_boxes.hpp"

namespace pelt::detail {
namespace {

void take_box(CrowdInstance& instance) {
  instance.root_box = box_root(instance.model.detail().bounds, instance.palette, instance.given);
  instance.has_moved = true;
}

/// Bytes that a pose holds.
std::size_t bytes_of(const CrowdPose& pose) {
  const std::size_t given = pose.memory ? sizeof(Arena) + pose.memory->capacity() : 0;
  return pose.palette.memory_bytes() + given;
}

/// Takes the box of vertices that joints pose.
void take_posed(CrowdInstance& instance) {
  instance.given = {};
  take_box(instance);
}

/// Computes the box at once, because the palette is in the caches now, and because this runs on all
/// threads on which the caller sets palettes.
Result<void> take_palette(CrowdInstance& instance, const JointMatrices& palette) {
  Result<void> set = instance.palette.set(palette);
  if (set) take_posed(instance);
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

Result<void> CrowdInstances::set_palette(std::uint32_t number, const JointMatrices& palette) {
  CrowdInstance& instance = (*this)[number];
  save_start(instance);
  return take_palette(instance, palette);
}

Result<void> CrowdInstances::set_dual_quaternions(std::uint32_t number,
                                                  std::span<const float> dual_quaternions) {
  CrowdInstance& instance = (*this)[number];
  save_start(instance);
  Result<void> taken = instance.palette.set_dual_quaternions(dual_quaternions);
  if (taken) take_posed(instance);
  return taken;
}

Result<void> CrowdInstances::set_morph_weights(std::uint32_t number,
                                               std::span<const float> weights) {
  CrowdInstance& instance = (*this)[number];
  save_start(instance);
  Result<void> taken = instance.palette.set_morph_weights(weights);
  if (taken) take_posed(instance);
  return taken;
}

Result<void> CrowdInstances::set_vertices(std::uint32_t number, std::span<const Vec3> vertices) {
  CrowdInstance& instance = (*this)[number];
  const Tree& tree = instance.model.detail().tree;
  save_start(instance);
  if (Problem found = check_vertices(tree, vertices); !found.empty())
    return invalid_argument(std::move(found));
  instance.given = refit_given(tree, vertices, instance.empty_memory());
  take_box(instance);
  return {};
}

Result<void> CrowdInstances::set_offsets(std::uint32_t number, std::span<const Vec3> offsets) {
  CrowdInstance& instance = (*this)[number];
  save_start(instance);
  if (Problem found = check_offsets(instance.model.detail().tree, offsets); !found.empty())
    return invalid_argument(std::move(found));
  instance.palette.set_offsets(offsets);
  take_posed(instance);
  return {};
}

CrowdPose& CrowdInstances::start_of(CrowdInstance& instance) {
  if (!instance.start) instance.start = std::make_unique<CrowdPose>(instance.model.detail().tree);
  instance.start->given = {};
  return *instance.start;
}

/// The pose before its first change in a step is the start of the step. Before the first step, an
/// instance whose pose is set stands still.
void CrowdInstances::save_start(CrowdInstance& instance) {
  if (step_ == 0) {
    instance.step = CrowdInstance::kNever;
  } else if (instance.step != step_) {
    CrowdPose& start = start_of(instance);
    start.palette = instance.palette;
    if (instance.given)
      start.given = copy_given(instance.model.detail().tree, instance.given, start.empty_memory());
    start.root_box = instance.root_box;
    instance.step = step_;
  }
}

/// Sets the palettes of both ends of a step by `set_joints(palette, from)` and
/// `set_joints(palette, to)`.
template <typename Joints, typename SetJoints>
Result<void> CrowdInstances::move(std::uint32_t number, const Joints& from, const Joints& to,
                                  const SetJoints& set_joints) {
  CrowdInstance& instance = (*this)[number];
  instance.step = CrowdInstance::kNever;
  CrowdPose& start = start_of(instance);
  start.palette = instance.palette;  // for the morph weights
  if (Result<void> set = set_joints(start.palette, from); !set) return set;
  start.root_box = box_root(instance.model.detail().bounds, start.palette, start.given);
  if (Result<void> set = set_joints(instance.palette, to); !set) return set;
  take_posed(instance);
  instance.step = step_;
  return {};
}

Result<void> CrowdInstances::set_motion(std::uint32_t number, const JointMatrices& from,
                                        const JointMatrices& to) {
  return move(number, from, to,
              [](Palette& palette, const JointMatrices& joints) { return palette.set(joints); });
}

Result<void> CrowdInstances::set_motion_dual_quaternions(std::uint32_t number,
                                                         std::span<const float> from,
                                                         std::span<const float> to) {
  return move(number, from, to, [](Palette& palette, std::span<const float> joints) {
    return palette.set_dual_quaternions(joints);
  });
}

std::size_t CrowdInstances::memory_bytes() const {
  std::size_t bytes = bytes_held(slots_, free_);
  for (const std::optional<CrowdInstance>& slot : slots_) {
    if (slot) {
      bytes += bytes_of(*slot);
      if (slot->start) bytes += sizeof(CrowdPose) + bytes_of(*slot->start);
    }
  }
  return bytes;
}

}  // namespace pelt::detail
