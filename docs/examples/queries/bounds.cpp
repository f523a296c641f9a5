#include <pelt/bounds.hpp>

// For culling, shadows and levels of detail: encloses the character in any pose.
pelt::Sphere sphere_around(pelt::Pose& pose, std::span<const pelt::Matrix4> palette) {
  if (!pose.set_palette(palette)) return {};
  pelt::Bounds found;
  pelt::bounds(pose, found);
  return found.sphere;
}

// For an exporter: the smallest box.
pelt::Box smallest_box(pelt::Pose& pose) {
  pelt::Bounds found;
  pelt::exact_bounds(pose, found);
  return found.box;
}
