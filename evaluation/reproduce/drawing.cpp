#include "evaluation/reproduce/drawing.hpp"

#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"

namespace pelt::reproduce {

Result<void> draw(const DrawingProgram& program, std::span<const std::string> command,
                  const std::filesystem::path& file, const std::string& description) {
  const auto written = tools::output::write_file(file, std::as_bytes(std::span(description)));
  if (!written) return written.error();
  const std::string name = program.name;
  const tools::output::ProgramEnd end = tools::output::run_program(command);
  if (end == tools::output::ProgramEnd::failed)
    return Error{ErrorCode::unsupported,
                 file.string() + ": " + name + " failed: run it to see why"};
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (end == tools::output::ProgramEnd::succeeded) return {};
  return Error{ErrorCode::unsupported, name + " is not installed: run `apt-get install " +
                                           program.package + "`, then this again"};
}

}  // namespace pelt::reproduce
