#include "tools/pelt/output/output_conflicts.hpp"

#include "text/message.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;
using Kind = OutputPlace::Kind;

/// A file, pipe or device: its device and inode if it exists, and its path, with the name in lower
/// case, if it is a file.
struct Identity {
  std::optional<std::pair<dev_t, ino_t>> inode;
  fs::path path;
};

fs::path canonical_in_lower_case(const fs::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path).parent_path(), ignored) / name;
}

bool is_null_device(const struct stat& known) {
  struct stat null = {};
  return S_ISCHR(known.st_mode) && stat("/dev/null", &null) == 0 && known.st_rdev == null.st_rdev;
}

/// The null device is like no file, because nothing can be lost there.
Identity identity_of(const OutputPlace& place) {
  Identity identity;
  struct stat known = {};
  const bool exists = place.descriptor >= 0 ? fstat(place.descriptor, &known) == 0
                                            : stat(place.path.c_str(), &known) == 0;
  if (exists && !is_null_device(known)) identity.inode.emplace(known.st_dev, known.st_ino);
  if (place.kind == Kind::file) identity.path = canonical_in_lower_case(place.path);
  return identity;
}

bool are_same(const Identity& a, const Identity& b) {
  return (a.inode && a.inode == b.inode) || (!a.path.empty() && a.path == b.path);
}

/// Files that no further output may be, with their roles for messages.
class TakenFiles {
 public:
  void add(Identity identity, const std::string& role) {
    files_.emplace_back(std::move(identity), role);
  }

  /// The role of the file if it is taken; otherwise adds the file.
  std::optional<std::string> take(const Identity& identity, const std::string& role) {
    for (const auto& [taken, role_of_taken] : files_)
      if (are_same(identity, taken)) return role_of_taken;
    add(identity, role);
    return std::nullopt;
  }

 private:
  std::vector<std::pair<Identity, std::string>> files_;
};

}  // namespace

bool is_standard_output_a_file() {
  struct stat known = {};
  return fstat(STDOUT_FILENO, &known) == 0 && S_ISREG(known.st_mode);
}

Result<void> check_outputs(std::span<const NamedOutput> outputs,
                           std::span<const InputFile> inputs) {
  TakenFiles files;
  for (const InputFile& input : inputs)
    files.add(identity_of(find_output_place(input.path.string())), input.role);
  // Summaries go to standard output even if no output does.
  const Identity printed = identity_of(find_output_place(kStandardOutput));
  if (is_standard_output_a_file()) {
    if (const auto taken = files.take(printed, "where standard output goes"))
      return text::bad_argument("standard output", "goes to " + *taken, "send it to another file");
  }
  for (const NamedOutput& output : outputs) {
    if (output.name.empty()) continue;
    const OutputPlace place = find_output_place(output.name);
    Identity identity = identity_of(place);
    if (place.kind == Kind::standard_output) {
      identity.path = kStandardOutput;
      if (is_standard_output_a_file()) identity.inode.reset();  // is taken by what is printed
    }
    if (const auto taken = files.take(identity, "the output of " + output.option))
      return text::bad_argument(output.option, output.name + " is " + *taken, output.remedy);
  }
  return {};
}

}  // namespace pelt::tools::output
