#pragma once

/// The instances of a crowd: their poses, and what queries have computed of them.

#include <pelt/crowd.hpp>

#include "model/model.hpp"
#include "pose/pose.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace pelt::detail {

/// One pose of an instance. Unlike opened nodes, given vertices stay from one query to the next.
struct CrowdPose : Instance {
  using Instance::Instance;

  /// Returns empty memory for given vertices.
  Arena& empty_memory() {
    if (!memory) memory = std::make_unique<Arena>();
    memory->clear();
    return *memory;
  }

  std::unique_ptr<Arena> memory;  // of given vertices, or null
};

/// An instance of a crowd. Its nodes are open during a query only.
struct CrowdInstance : CrowdPose {
  CrowdInstance(SkinnedModel m, const CollisionMask& c)
      : CrowdPose(m.detail().tree), mask(c), model(std::move(m)) {}

  /// View of the instance for the thread that owns `arena`.
  PosedTree posed_tree(Arena& arena) { return view(*this, arena); }

  /// View at the start of a step. An instance that stands still has one pose.
  PosedTree start_tree(bool moves, Arena& arena) { return view(moves ? *start : *this, arena); }

  /// Closes all nodes, whose memory will be reused.
  void close() {
    opened = OpenedNodes();
    if (start) start->opened = OpenedNodes();
  }

  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  bool has_moved = true;             // since the last query
  std::uint64_t step = kNever;       // the step that `start` is of
  std::unique_ptr<CrowdPose> start;  // or null
  CollisionMask mask;
  SkinnedModel model;

 private:
  PosedTree view(Instance& instance, Arena& arena) const {
    return instance.posed_tree(model.detail().tree, model.detail().bounds, arena);
  }
};

/// The instances of a crowd by number. Some numbers may be free.
class CrowdInstances {
 public:
  std::uint32_t add(const SkinnedModel& model, const CollisionMask& mask);
  void remove(std::uint32_t number);

  /// Number of instances.
  std::uint32_t count() const { return count_; }

  /// One more than the highest number ever assigned.
  std::uint32_t end() const { return static_cast<std::uint32_t>(slots_.size()); }

  bool has(std::uint32_t number) const { return slots_[number].has_value(); }

  /// Precondition: the instance exists.
  CrowdInstance& operator[](std::uint32_t number);

  /// Several threads may call it for different instances.
  Result<void> set_palette(std::uint32_t number, const JointMatrices& palette);
  Result<void> set_dual_quaternions(std::uint32_t number, std::span<const float> dual_quaternions);
  Result<void> set_morph_weights(std::uint32_t number, std::span<const float> weights);
  Result<void> set_vertices(std::uint32_t number, std::span<const Vec3> vertices);
  Result<void> set_offsets(std::uint32_t number, std::span<const Vec3> offsets);

  /// See Crowd.
  void begin_step() { ++step_; }
  Result<void> set_motion(std::uint32_t number, const JointMatrices& from, const JointMatrices& to);
  Result<void> set_motion_dual_quaternions(std::uint32_t number, std::span<const float> from,
                                           std::span<const float> to);

  /// Whether an instance has different poses at the ends of the step.
  bool moves(std::uint32_t number) { return (*this)[number].step == step_; }

  std::size_t memory_bytes() const;

 private:
  void add_slot();
  void save_start(CrowdInstance& instance);
  static CrowdPose& start_of(CrowdInstance& instance);

  template <typename Joints, typename SetJoints>
  Result<void> move(std::uint32_t number, const Joints& from, const Joints& to,
                    const SetJoints& set_joints);

  std::vector<std::optional<CrowdInstance>> slots_;
  std::vector<std::uint32_t> free_;
  std::uint32_t count_ = 0;
  std::uint64_t step_ = 0;  // number of steps begun
};

}  // namespace pelt::detail
