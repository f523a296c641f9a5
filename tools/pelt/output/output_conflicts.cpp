#include "tools/pelt/output/output_conflicts.hpp"

#include "tools/pelt/output/output_place.hpp"
#include "tools/pelt/output/text.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;
using Kind = OutputPlace::Kind;

/// Identifies a file in the system.
using Inode = std::pair<dev_t, ino_t>;

/// A file: its inode if it exists; otherwise the inode of its folder, if that exists, and its name
/// in lower case.
struct Identity {
  std::optional<Inode> file, folder;
  std::string name;
};

bool is_null_device(const struct stat& known) {
  struct stat null = {};
  return S_ISCHR(known.st_mode) && stat("/dev/null", &null) == 0 && known.st_rdev == null.st_rdev;
}

/// Nullopt for /dev/null, where nothing can be lost.
std::optional<Inode> inode_of(const struct stat& known) {
  if (is_null_device(known)) return std::nullopt;
  return Inode(known.st_dev, known.st_ino);
}

std::optional<Inode> inode_of(const fs::path& path) {
  struct stat known = {};
  return stat(path.c_str(), &known) == 0 ? inode_of(known) : std::nullopt;
}

/// The file, pipe or device that a descriptor is open for.
std::optional<Inode> inode_of(int descriptor) {
  struct stat known = {};
  return fstat(descriptor, &known) == 0 ? inode_of(known) : std::nullopt;
}

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Identity identity_of(const OutputPlace& place) {
  if (place.descriptor >= 0) return {inode_of(place.descriptor), std::nullopt, ""};
  if (place.kind == Kind::device) return {inode_of(place.path), std::nullopt, ""};
  return {inode_of(place.path), inode_of(place.path.parent_path()),
          in_lower_case(place.path.filename().string())};
}

/// Follows links.
Identity identity_of(const std::string& name) { return identity_of(find_output_place(name)); }

bool are_same(const Identity& a, const Identity& b) {
  if (a.file && a.file == b.file) return true;
  return a.folder && a.folder == b.folder && a.name == b.name;
}

Error refusal(const NamedOutput& output, const std::string& what) {
  return bad_argument(output.option, output.name + " is " + what, output.remedy);
}

/// Outputs and inputs; no output may be another file of these.
class Conflicts {
 public:
  explicit Conflicts(std::span<const InputFile> inputs) {
    for (const InputFile& input : inputs) add(identity_of(input.path.string()), input.role);
  }

  /// Adds the file that the shell redirects standard output to; summaries go there even if no
  /// output does. Returns the input that the file is; nullopt if there is none.
  std::optional<std::string> take_standard_output() {
    if (!is_standard_output_a_file()) return std::nullopt;
    return take(identity_of(kStandardOutput), "where standard output goes");
  }

  /// The other file that the output is; nullopt if there is none.
  std::optional<std::string> take(const NamedOutput& output) {
    const OutputPlace place = find_output_place(output.name);
    if (place.kind == Kind::standard_output) {
      if (!standard_output_.empty()) return "the output of " + standard_output_;
      standard_output_ = output.option;
      if (is_standard_output_a_file()) return std::nullopt;  // added already
    }
    return take(identity_of(place), "the output of " + output.option);
  }

 private:
  /// The role of the same file if there is one; otherwise adds the file.
  std::optional<std::string> take(Identity identity, const std::string& role) {
    for (const auto& [known, known_role] : known_) {
      if (are_same(identity, known)) return known_role;
    }
    add(std::move(identity), role);
    return std::nullopt;
  }

  void add(Identity identity, const std::string& role) {
    known_.emplace_back(std::move(identity), role);
  }

  std::vector<std::pair<Identity, std::string>> known_;
  std::string standard_output_;  // the option that uses it
};

}  // namespace

bool is_standard_output_a_file() {
  struct stat known = {};
  return fstat(STDOUT_FILENO, &known) == 0 && S_ISREG(known.st_mode);
}

Result<void> check_outputs(std::span<const NamedOutput> outputs,
                           std::span<const InputFile> inputs) {
  Conflicts conflicts(inputs);
  if (const auto conflict = conflicts.take_standard_output())
    return bad_argument("standard output", "goes to " + *conflict, "send it to another file");
  for (const NamedOutput& output : outputs) {
    if (output.name.empty()) continue;
    if (const auto conflict = conflicts.take(output)) return refusal(output, *conflict);
  }
  return {};
}

}  // namespace pelt::tools::output
