#pragma once

/// The region on the command line of `pelt region`.

#include <pelt/region.hpp>

#include "tools/pelt/arguments/verb.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::arguments {

struct RegionArguments {
  std::string box, sphere, capsule, camera;
  std::optional<double> angle, aspect;  ///< of the camera
};

void add_region_options(Verb& verb, RegionArguments& arguments);

/// A region, with its values on the command line.
class ChosenRegion {
 public:
  ChosenRegion(const std::string& kind, std::vector<float> numbers);

  /// The region that a camera sees, without a far plane: a pyramid without a base. `angle` is the
  /// horizontal field of view in turns.
  static ChosenRegion seen_by_camera(std::vector<float> numbers, double angle, double aspect);

  Region region() const;

  const std::string& kind() const { return kind_; }               ///< "box"
  const std::vector<float>& numbers() const { return numbers_; }  ///< as given

 private:
  std::string kind_;
  std::vector<float> numbers_;
  std::vector<HalfSpace> faces_;
};

/// Error messages name the option.
Result<ChosenRegion> choose_region(const RegionArguments& arguments);

}  // namespace pelt::tools::arguments
