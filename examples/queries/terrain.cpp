#include <pelt/height_field.hpp>

// The triangles of a character that are in the ground; `ground` is made once.
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
