/// prepared_seeds FOLDER: writes small prepared models as seeds for fuzzing.

#include "support/skinned_shapes.hpp"

#include <pelt/model.hpp>

#include <filesystem>
#include <fstream>

namespace {

using pelt::test::Shape;
using pelt::test::Weights;

void write(const std::filesystem::path& path, const Shape& shape) {
  const std::vector<std::byte> file = pelt::save_model(*pelt::build_model(shape.view()));
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  pelt::test::Random random(305);
  write(folder / "triangle.pelt", make_soup(random, 1, 1, 1, Weights::one_joint));
  write(folder / "soup.pelt", make_soup(random, 60, 5, 4, Weights::adversarial));
  write(folder / "limb.pelt", pelt::test::make_morphing_limb(20, 8, 3));
  write(folder / "long_limb.pelt", pelt::test::make_limb(60, 12, 8));
  return 0;
}
