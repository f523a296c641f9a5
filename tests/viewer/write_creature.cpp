/// write_creature FILE TRIANGLES SEED: a generated character with its skin and clips, as .glb.

#include "scenes/character_glb.hpp"
#include "scenes/creature.hpp"

#include <cstdlib>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  pelt::scenes::CreatureOptions options = pelt::scenes::kDwarf;
  options.triangles = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
  options.seed = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
  const auto creature = pelt::scenes::make_creature(options);
  if (!creature) return 1;
  const std::vector<std::byte> bytes = pelt::scenes::character_glb(*creature);
  std::ofstream out(argv[1], std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return out.flush() ? 0 : 1;
}
