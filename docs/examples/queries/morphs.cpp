#include <pelt/pose.hpp>

// Weights and palette are independent; the order of the two calls does not matter.
bool pose_face(pelt::Pose& pose, std::span<const pelt::Matrix4> palette,
               std::span<const float> weights) {
  return pose.set_palette(palette) && pose.set_morph_weights(weights);
}
