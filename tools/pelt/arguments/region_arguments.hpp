#pragma once

/// The region that the command line of `pelt region` names.

#include <pelt/region.hpp>

#include "tools/pelt/arguments/verb.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::arguments {

struct RegionArguments {
  std::string box, sphere, capsule, camera;
  std::optional<double> angle, aspect;  ///< of the camera's view
};

void add_region_options(Verb& verb, RegionArguments& arguments);

/// A region, with what the command line said of it.
class ChosenRegion {
 public:
  ChosenRegion(const std::string& kind, std::vector<float> numbers);

  /// What a camera sees, however far: a pyramid without a base. `angle` is in turns, from the left
  /// side to the right one.
  static ChosenRegion seen_by_camera(std::vector<float> numbers, double angle, double aspect);

  Region region() const;

  const std::string& kind() const { return kind_; }               ///< "box"
  const std::vector<float>& numbers() const { return numbers_; }  ///< as given

 private:
  std::string kind_;
  std::vector<float> numbers_;
  std::vector<HalfSpace> faces_;
};

/// The message of an error names the option.
Result<ChosenRegion> choose_region(const RegionArguments& arguments);

}  // namespace pelt::tools::arguments
