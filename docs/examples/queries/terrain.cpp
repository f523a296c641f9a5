#include <pelt/height_field.hpp>
#include <pelt/solid.hpp>

// The triangles of a character that intersect the ground. Create `ground` once.
std::vector<std::uint32_t> grounded(pelt::Pose& pose, const pelt::HeightField& ground,
                                    pelt::Scratch& scratch) {
  std::vector<pelt::Contact> contacts;
  pelt::collide(pose, ground, scratch, contacts);
  std::vector<std::uint32_t> triangles;
  for (const pelt::Contact& contact : contacts)
    if (triangles.empty() || triangles.back() != contact.triangle_a)
      triangles.push_back(contact.triangle_a);
  return triangles;
}

// Distance of the whole skin from a pillar; 0 if they touch.
double from_pillar(pelt::Pose& pose, const pelt::Capsule& pillar, pelt::Scratch& scratch) {
  pelt::SolidDistance closest;
  pelt::distance(pose, pillar, scratch, closest);
  return closest.distance;  // closest.surface and closest.solid say where
}
