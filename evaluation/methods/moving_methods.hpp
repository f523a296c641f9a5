#pragma once

/// The methods of `pelt-lab bench --moving`, behind one interface. All find the same contacts; they
/// differ in their work.

#include <pelt/motion.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace pelt::lab {

/// Bodies that move from pose to pose, and queries for the contacts of their steps. Bodies are
/// numbered in the order of `add`. Each body has the poses of both ends of the current step.
class MovingMethod {
 public:
  virtual ~MovingMethod() = default;

  /// Adds a body, with the rest pose at both ends.
  virtual void add(const SkinnedModel& model) = 0;

  /// Begins a step of all bodies: the end of the step before becomes the start. Then set the
  /// palette of each body.
  virtual void begin_step() = 0;

  /// Sets the weights of a body's morph targets for the next joint palette.
  virtual Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) = 0;

  /// Sets the joint palette of a body at the end of the step, and does the work that the method
  /// does before queries.
  virtual Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) = 0;

  /// Appends the contacts of two bodies at the end of the step, ascending; see pelt::collide.
  virtual QueryStats collide_at_end(std::uint32_t a, std::uint32_t b,
                                    std::vector<Contact>& contacts) = 0;

  /// Appends the contacts of two bodies during the step, ascending; see pelt::collide.
  virtual MovingStats collide_moving(std::uint32_t a, std::uint32_t b,
                                     std::vector<MovingContact>& contacts,
                                     const MovingOptions& options) = 0;

  /// Whether first_contact may be called.
  virtual bool finds_first_contact() const { return true; }

  /// See pelt::first_contact.
  virtual MovingStats first_contact(std::uint32_t a, std::uint32_t b,
                                    std::optional<MovingContact>& first) = 0;

  /// The work of set_palette so far; queries return their own work.
  virtual QueryStats update_work() const = 0;
};

/// A method that can be selected by name.
struct MovingMethodKind {
  std::string_view name;  ///< on the command line
  std::unique_ptr<MovingMethod> (*make)();

  constexpr bool operator==(const MovingMethodKind& other) const { return name == other.name; }
};

std::unique_ptr<MovingMethod> make_moving_on_demand();
std::unique_ptr<MovingMethod> make_moving_eager();
std::unique_ptr<MovingMethod> make_moving_united();
std::unique_ptr<MovingMethod> make_moving_brute();

/// The public functions: nodes are opened on demand at both ends of a step.
inline constexpr MovingMethodKind kMovingOnDemand = {"on_demand", make_moving_on_demand};

/// The same tree, wide code and query, but every new palette skins all vertices and computes all
/// boxes bottom-up. A step computes one end; the other is the end of the step before.
inline constexpr MovingMethodKind kMovingEager = {"eager", make_moving_eager};

/// An ablation of on_demand: prunes nodes and triangles by one box over the whole step, as is usual
/// in continuous collision detection, instead of by the boxes of both ends and the times at which
/// they overlap. The rest is the same. Finds no first contact.
inline constexpr MovingMethodKind kMovingUnited = {"united", make_moving_united};

/// The oracle: decides every pair of triangles whose extents during the step overlap, without a
/// tree and without the certified test in float.
inline constexpr MovingMethodKind kMovingBrute = {"brute", make_moving_brute};

inline constexpr std::array kMovingMethods = {kMovingOnDemand, kMovingEager, kMovingUnited,
                                              kMovingBrute};

}  // namespace pelt::lab
