#include "evaluation/reproduce/picture.hpp"

#include "evaluation/reproduce/drawing.hpp"

namespace pelt::reproduce {

namespace fs = std::filesystem;

Result<void> render(const Picture& picture, const fs::path& png) {
  fs::path file = png;
  file.replace_extension(".pov");
  const std::vector<std::string> command = {"povray",
                                            "+I" + file.string(),
                                            "+O" + png.string(),
                                            "+W" + std::to_string(picture.width),
                                            "+H" + std::to_string(picture.height),
                                            "+A0.2",
                                            "-D",
                                            "-P",
                                            "+Q9"};
  return draw({"POV-Ray", "povray"}, command, file, picture.description);
}

}  // namespace pelt::reproduce
