/// Renders pictures into the folder that is the first argument: those of docs/queries.md
/// (docs/figures/queries), or the pictures that the other arguments name. "through", "resting" and
/// "crease" are those of docs/self-collision.md (docs/figures/self).

#include "evaluation/pictures/pictures.hpp"
#include "evaluation/reproduce/drawing.hpp"
#include "tools/pelt/output/process.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <span>
#include <vector>

namespace {

using namespace pelt;

/// Reduces the number of colours, which shrinks the file to a third.
void shrink(const std::filesystem::path& png) {
  const std::vector<std::string> command = {"convert", png.string(), "+dither",
                                            "-colors", "256",        "PNG8:" + png.string()};
  if (tools::output::run_program(command) != tools::output::ProgramEnd::succeeded)
    std::fprintf(stderr, "%s stays large: ImageMagick did not shrink it\n", png.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pelt::pictures;
  if (argc < 2) {
    std::fprintf(stderr, "usage: draw_queries FOLDER [NAME...]\n");
    return 2;
  }
  tools::output::remove_unfinished_files_on_signals();
  const std::span<char*> wanted(argv + 2, argv + argc);
  const std::filesystem::path folder = argv[1];
  struct Entry {
    std::string_view name;
    Picture (*draw)();
  };
  constexpr Entry kAll[] = {
      {"bounds", bounds_picture},     {"culling", culling_picture}, {"ray", ray_picture},
      {"distance", distance_picture}, {"contact", contact_picture}, {"terrain", terrain_picture},
      {"inside", inside_picture},     {"morphs", morph_picture},    {"skinning", skinning_picture}};
  constexpr Entry kOfSelf[] = {
      {"through", through_picture}, {"resting", resting_picture}, {"crease", crease_picture}};
  const auto is_named = [&](const Entry& entry) {
    return std::find(wanted.begin(), wanted.end(), entry.name) != wanted.end();
  };
  std::vector<Entry> chosen;
  for (const Entry& entry : kAll)
    if (wanted.empty() || is_named(entry)) chosen.push_back(entry);
  std::copy_if(std::begin(kOfSelf), std::end(kOfSelf), std::back_inserter(chosen), is_named);
  for (const auto& [name, draw] : chosen) {
    const std::filesystem::path png = folder / (std::string(name) + ".png");
    if (const Result<void> rendered = reproduce::render(draw(), png); !rendered) {
      std::fprintf(stderr, "%s\n", rendered.error().message.c_str());
      return 1;
    }
    shrink(png);
  }
  return 0;
}
