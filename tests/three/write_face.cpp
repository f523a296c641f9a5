/// write_face FILE: a generated face, with its morph targets and the clip that moves them, as .glb.

#include "scenes/character_glb.hpp"
#include "scenes/creature.hpp"

#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto face = pelt::scenes::make_face();
  if (!face) return 1;
  const std::vector<std::byte> bytes = pelt::scenes::character_glb(*face);
  std::ofstream out(argv[1], std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return out.flush() ? 0 : 1;
}
