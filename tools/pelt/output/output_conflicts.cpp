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

std::optional<Inode> inode_of(const fs::path& path) {
  struct stat known = {};
  if (stat(path.c_str(), &known) != 0) return std::nullopt;
  return Inode(known.st_dev, known.st_ino);
}

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// Follows links.
Identity identity_of(const fs::path& path) {
  const fs::path place = find_output_place(path.string()).path;
  return {inode_of(place), inode_of(place.parent_path()), in_lower_case(place.filename().string())};
}

bool are_same(const Identity& a, const Identity& b) {
  if (a.file && a.file == b.file) return true;
  return a.folder && a.folder == b.folder && a.name == b.name;
}

/// The file that standard output goes to; nullopt if it is not a file.
std::optional<Identity> standard_output_file() {
  struct stat known = {};
  if (fstat(STDOUT_FILENO, &known) != 0 || !S_ISREG(known.st_mode)) return std::nullopt;
  return Identity{Inode(known.st_dev, known.st_ino), std::nullopt, ""};
}

Error refusal(const NamedOutput& output, const std::string& what) {
  return bad_argument(output.option, output.name + " is " + what, output.remedy);
}

/// Outputs and inputs; no output may be another file of these.
class Conflicts {
 public:
  explicit Conflicts(std::span<const InputFile> inputs) {
    for (const InputFile& input : inputs) add(identity_of(input.path), input.role);
    if (auto file = standard_output_file()) add(*std::move(file), "where standard output goes");
  }

  /// The other file that the output is; nullopt if there is none.
  std::optional<std::string> take(const NamedOutput& output) {
    const OutputPlace place = find_output_place(output.name);
    if (place.kind == Kind::standard_output) return take_standard_output(output.option);
    if (place.kind != Kind::file) return std::nullopt;
    Identity identity = identity_of(place.path);
    for (const auto& [known, role] : known_) {
      if (are_same(identity, known)) return role;
    }
    add(std::move(identity), "the output of " + output.option);
    return std::nullopt;
  }

 private:
  void add(Identity identity, const std::string& role) {
    known_.emplace_back(std::move(identity), role);
  }

  std::optional<std::string> take_standard_output(const std::string& option) {
    if (!standard_output_.empty()) return "the output of " + standard_output_;
    standard_output_ = option;
    return std::nullopt;
  }

  std::vector<std::pair<Identity, std::string>> known_;
  std::string standard_output_;  // the option that uses it
};

}  // namespace

Result<void> check_outputs(std::span<const NamedOutput> outputs,
                           std::span<const InputFile> inputs) {
  Conflicts conflicts(inputs);
  for (const NamedOutput& output : outputs) {
    if (output.name.empty()) continue;
    if (const auto conflict = conflicts.take(output)) return refusal(output, *conflict);
  }
  return {};
}

}  // namespace pelt::tools::output
