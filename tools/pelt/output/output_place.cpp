#include "tools/pelt/output/output_place.hpp"

#include <unistd.h>

#include <charconv>
#include <optional>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;
using Kind = OutputPlace::Kind;

/// The same file with the links of its folder resolved; unchanged if the folder does not exist.
fs::path in_real_folder(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", error);
  return error ? path : folder / path.filename();
}

/// The number of an open descriptor, which links like /dev/stdout refer to.
std::optional<int> descriptor_at(const fs::path& path) {
  std::error_code error;
  const fs::path open_descriptors = fs::canonical("/dev/fd", error);
  if (error || path.parent_path() != open_descriptors) return std::nullopt;
  const std::string name = path.filename().string();
  int number = -1;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), number);
  if (parsed.ec != std::errc() || *parsed.ptr != '\0') return std::nullopt;
  return number;
}

OutputPlace place_at(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool replaced =
      !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
  return {replaced ? Kind::file : Kind::device, path, -1};
}

}  // namespace

OutputPlace find_output_place(const std::string& name) {
  if (name == kStandardOutput) return {Kind::standard_output, {}, STDOUT_FILENO};
  constexpr int kMaxLinks = 40;
  fs::path path = in_real_folder(name);
  for (int i = 0; i < kMaxLinks; ++i) {
    if (const auto number = descriptor_at(path))
      return {*number == STDOUT_FILENO ? Kind::standard_output : Kind::descriptor, {}, *number};
    std::error_code error;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = in_real_folder(path.parent_path() / next);
  }
  return place_at(path);
}

bool is_standard_output(const std::string& name) {
  return !name.empty() && find_output_place(name).kind == Kind::standard_output;
}

}  // namespace pelt::tools::output
