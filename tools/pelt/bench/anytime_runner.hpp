#pragma once

/// A method of `pelt bench --anytime` with the colliders of a scene.

#include "tools/pelt/methods/anytime_method.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <functional>
#include <string>

namespace pelt::tools::bench {

/// A method, and its names.
struct AnytimeBenchMethod {
  std::string name, title;
  std::function<std::unique_ptr<methods::AnytimeMethod>()> make;
};

AnytimeBenchMethod anytime_method_of(const methods::AnytimeMethodKind& kind);

/// Two instances that are in contact in a frame.
struct AnytimeCase {
  std::uint32_t frame = 0, a = 0, b = 0;
  std::uint64_t contacts = 0;
};

class AnytimeRunner {
 public:
  /// `colliders` must outlive the runner.
  AnytimeRunner(std::span<const scene::Collider> colliders, const AnytimeBenchMethod& method);

  /// Poses both instances of a case, and starts a search of them. Error messages name the instance.
  Result<void> start(const AnytimeCase& of, const scene::Palettes& palettes);

  /// Poses both instances, so that nothing is refitted, and leaves the search to be restarted.
  Result<void> pose(const AnytimeCase& of, const scene::Palettes& palettes);

  methods::AnytimeMethod& method() { return *method_; }

 private:
  std::span<const scene::Collider> colliders_;
  scene::InputSelection selection_;
  std::unique_ptr<methods::AnytimeMethod> method_;
};

}  // namespace pelt::tools::bench
