#pragma once

/// The region on the command line of `pelt region`.

#include <pelt/solid.hpp>

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

/// The picture of a camera.
struct FieldOfView {
  double degrees;  ///< horizontal
  double aspect;   ///< width over height
};

/// A region, with its values on the command line.
class ChosenRegion {
 public:
  ChosenRegion(const std::string& kind, std::vector<float> numbers);

  /// The region that a camera sees, without a far plane: a pyramid without a base.
  static ChosenRegion seen_by_camera(std::vector<float> numbers, const FieldOfView& view);

  Region region() const;

  const std::string& kind() const { return kind_; }                 ///< "box"
  const std::vector<float>& numbers() const { return numbers_; }    ///< as given
  const std::optional<FieldOfView>& view() const { return view_; }  ///< of a camera

 private:
  std::string kind_;
  std::vector<float> numbers_;
  std::optional<FieldOfView> view_;
  std::vector<HalfSpace> faces_;
};

/// Error messages name the option.
Result<ChosenRegion> choose_region(const RegionArguments& arguments);

}  // namespace pelt::tools::arguments
