#pragma once

/// Contacts of characters with themselves, as scene files and command lines choose them.

#include <cstdint>
#include <optional>

namespace pelt::scenes {

/// Whether a check tests bodies against each other, against themselves, or both.
enum class SelfContacts : std::uint8_t {
  none,    ///< pairs of bodies only
  beside,  ///< pairs of bodies, and each body against itself
  only,    ///< each body against itself only
};

/// Choices that are not set have the defaults of the command (see docs/self-collision.md).
struct SelfOptions {
  std::optional<SelfContacts> wanted;
  std::optional<std::uint32_t> rings;
  std::optional<bool> drops_at_rest;
  std::optional<double> always;  ///< share of the poses, at most 1; 0: drops nothing
  std::optional<bool> drops_near_joints;
};

inline constexpr std::uint32_t kMaxSelfRings = 64;

/// Returns the choices of `first`, and those of `second` where `first` has none.
inline SelfOptions chosen_first(const SelfOptions& first, const SelfOptions& second) {
  const auto either = [](const auto& a, const auto& b) { return a ? a : b; };
  return {either(first.wanted, second.wanted), either(first.rings, second.rings),
          either(first.drops_at_rest, second.drops_at_rest), either(first.always, second.always),
          either(first.drops_near_joints, second.drops_near_joints)};
}

}  // namespace pelt::scenes
