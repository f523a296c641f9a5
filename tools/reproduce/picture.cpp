#include "tools/reproduce/picture.hpp"

#include "tools/pelt/output.hpp"
#include "tools/pelt/run_program.hpp"

namespace pelt::reproduce {

namespace fs = std::filesystem;

Result<void> render(const Picture& picture, const fs::path& png) {
  fs::path file = png;
  file.replace_extension(".pov");
  const auto written = tools::write_file(file, std::as_bytes(std::span(picture.description)));
  if (!written) return written.error();
  const std::vector<std::string> command = {"povray",
                                            "+I" + file.string(),
                                            "+O" + png.string(),
                                            "+W" + std::to_string(picture.width),
                                            "+H" + std::to_string(picture.height),
                                            "+A0.2",
                                            "-D",
                                            "-P",
                                            "+Q9"};
  const tools::ProgramEnd end = tools::run_program(command);
  if (end == tools::ProgramEnd::failed)
    return Error{ErrorCode::unsupported, file.string() + ": POV-Ray failed: run it to see why"};
  std::error_code ignored;
  fs::remove(file, ignored);
  if (end == tools::ProgramEnd::succeeded) return {};
  return Error{ErrorCode::unsupported,
               "POV-Ray is not installed: run `apt-get install povray`, then this again"};
}

}  // namespace pelt::reproduce
