#include <pelt/pelt.hpp>

#include <cstdio>
#include <vector>

// A ribbon with three rungs, one above the other: the lowest follows joint 0, the highest joint 1.
const pelt::Vec3 kPositions[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
const pelt::Triangle kTriangles[] = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
const std::uint16_t kJoints[] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
const float kWeights[] = {1, 0, 1, 0, 0.5, 0.5, 0.5, 0.5, 0, 1, 0, 1};

int main() {
  const auto model = pelt::build_model({kPositions, kTriangles, 2, kJoints, kWeights, 2});
  if (!model) {
    std::puts(model.error().message.c_str());
    return 1;
  }

  pelt::Pose a(*model), b(*model);
  pelt::Matrix4 palette_a[2], palette_b[2];  // column-major; [12] [13] [14] is the translation
  palette_b[0].m[14] = palette_b[1].m[14] = 1;
  if (!b.set_palette(palette_b)) return 1;  // b stands one unit in front of a

  pelt::Scratch scratch;
  std::vector<pelt::Contact> contacts;
  for (const float lean : {0.0f, 0.5f, 1.0f, 1.5f}) {
    palette_a[1].m[14] = lean;  // a leans towards b
    if (!a.set_palette(palette_a)) return 1;
    contacts.clear();
    pelt::collide(a, b, scratch, contacts);
    std::printf("lean %.1f: %zu contacts\n", lean, contacts.size());
  }
}
