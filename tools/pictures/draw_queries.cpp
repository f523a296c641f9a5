/// Renders the pictures of docs/queries.md into the folder named on the command line, docs/figures:
/// all of them, or those whose names follow.

#include "tools/pictures/pictures.hpp"
#include "tools/reproduce/picture.hpp"

#include <algorithm>
#include <cstdio>
#include <span>

int main(int argc, char** argv) {
  using namespace pelt::pictures;
  if (argc < 2) {
    std::fprintf(stderr, "usage: draw_queries FOLDER [NAME...]\n");
    return 2;
  }
  const std::span<char*> wanted(argv + 2, argv + argc);
  const std::filesystem::path folder = argv[1];
  struct Entry {
    std::string_view name;
    Picture (*draw)();
  };
  constexpr Entry kAll[] = {{"bounds", bounds_picture},   {"culling", culling_picture},
                            {"ray", ray_picture},         {"distance", distance_picture},
                            {"contact", contact_picture}, {"inside", inside_picture},
                            {"morphs", morph_picture}};
  for (const auto& [name, draw] : kAll) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    const pelt::Result<void> rendered =
        pelt::reproduce::render(draw(), folder / (std::string(name) + ".png"));
    if (rendered) continue;
    std::fprintf(stderr, "%s\n", rendered.error().message.c_str());
    return 1;
  }
  return 0;
}
