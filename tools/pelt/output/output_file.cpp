#include "tools/pelt/output/output_file.hpp"

#include "text/format.hpp"
#include "text/printable.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <random>
#include <system_error>
#include <utility>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;
using Kind = OutputPlace::Kind;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// The number of an open descriptor, which links like /dev/stdout refer to.
std::optional<std::uint32_t> descriptor_at(const fs::path& path) {
  std::error_code error;
  std::uint32_t number = 0;
  if (!fs::equivalent(folder_of(path), "/dev/fd", error) ||
      !text::parse_whole(path.filename().string(), number))
    return std::nullopt;
  return number;
}

OutputPlace place_at(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool replaced =
      !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
  return {replaced ? Kind::file : Kind::device, path, -1};
}

/// An unused name in the folder. Has the extension of the file, because programs recognise kinds of
/// files by it.
fs::path temporary_beside(const fs::path& path) {
  std::random_device random;
  const std::uint64_t number = std::uint64_t{random()} << 32 | random();
  return path.parent_path() /
         (".pelt-" + text::hex16(number) + ".partial" + path.extension().string());
}

/// Whether the file at `path` may be replaced. `known` describes the file unless it is new.
bool is_replaceable(const fs::path& path, struct stat& known, bool& is_new) {
  is_new = stat(path.c_str(), &known) != 0 && errno == ENOENT;
  if (is_new) return path.has_filename();
  if (S_ISDIR(known.st_mode)) errno = EISDIR;
  return !S_ISDIR(known.st_mode) && access(path.c_str(), W_OK) == 0;
}

/// Copies owner and permissions of the file that `descriptor` will replace. Only the superuser can
/// change owners, so a failure is not an error.
void take_over(int descriptor, const struct stat& known) {
  if (fchown(descriptor, known.st_uid, known.st_gid) != 0) errno = 0;
  fchmod(descriptor, known.st_mode & 07777);
}

}  // namespace

OutputPlace find_output_place(const std::string& name) {
  if (name == kStandardOutput) return {Kind::standard_output, {}, STDOUT_FILENO};
  constexpr int kMaxLinks = 40;
  fs::path path = name;
  for (int i = 0; i < kMaxLinks; ++i) {
    if (const auto number = descriptor_at(path)) {
      const int descriptor = static_cast<int>(*number);
      const bool is_output = descriptor == STDOUT_FILENO;
      return {is_output ? Kind::standard_output : Kind::descriptor, {}, descriptor};
    }
    std::error_code error;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;
  }
  return place_at(path);
}

bool is_standard_output(const std::string& name) {
  return !name.empty() && find_output_place(name).kind == Kind::standard_output;
}

DescriptorBuffer::~DescriptorBuffer() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void DescriptorBuffer::open(int descriptor) {
  descriptor_ = descriptor;
  buffer_.resize(1 << 16);
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

bool DescriptorBuffer::close() {
  sync();
  if (::close(std::exchange(descriptor_, -1)) != 0 && error_ == 0) error_ = errno;
  return error_ == 0;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
  if (sync() != 0) return traits_type::eof();
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  return sputc(traits_type::to_char_type(c));
}

int DescriptorBuffer::sync() {
  const char* rest = pbase();
  while (rest < pptr() && error_ == 0) {
    const ssize_t written = ::write(descriptor_, rest, static_cast<std::size_t>(pptr() - rest));
    if (written >= 0)
      rest += written;
    else if (errno != EINTR)
      error_ = errno;
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0 ? 0 : -1;
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

Result<void> OutputFile::open(const std::string& name) {
  name_ = name;
  if (name.empty()) return {};
  const OutputPlace place = find_output_place(name);
  if (place.kind == Kind::standard_output) {
    stream_ = &std::cout;
    return {};
  }
  const int descriptor = open_place(place);
  if (descriptor < 0) return unwritable(name, errno);
  buffer_.open(descriptor);
  stream_ = &file_;
  return {};
}

int OutputFile::open_place(const OutputPlace& place) {
  if (place.kind == Kind::descriptor) return fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0);
  if (place.kind == Kind::device) return ::open(place.path.c_str(), O_WRONLY | O_CLOEXEC);
  return open_beside(place.path);
}

int OutputFile::open_beside(const fs::path& path) {
  struct stat known = {};
  bool is_new = false;
  if (!is_replaceable(path, known, is_new)) return -1;
  const fs::path temporary = temporary_beside(path);
  unfinished_.emplace(temporary);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    unfinished_.reset();
    return -1;
  }
  place_ = path;
  temporary_ = temporary;
  if (!is_new) take_over(descriptor, known);
  return descriptor;
}

Result<void> OutputFile::close() {
  if (stream_ == nullptr) return {};
  std::ostream& stream = *std::exchange(stream_, nullptr);
  if (&stream == &std::cout) return flush_standard_output();
  if (!buffer_.close() || !stream) return unwritable(name_, buffer_.error());
  if (temporary_.empty()) return {};
  if (rename(temporary_.c_str(), place_.c_str()) != 0) return unwritable(name_, errno);
  temporary_.clear();
  unfinished_.reset();
  return {};
}

Result<void> OutputFile::write_and_close(std::span<const std::byte> bytes) {
  if (stream_ == nullptr) return unwritable(name_);
  stream_->write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  return close();
}

Result<void> write_file(const std::string& name, std::span<const std::byte> bytes) {
  OutputFile file;
  if (const auto opened = file.open(name); !opened) return opened;
  return file.write_and_close(bytes);
}

Error unwritable(const std::string& name, int error) {
  const std::string why = error == 0 ? "" : ": " + std::generic_category().message(error);
  if (name == kStandardOutput) {
    return {ErrorCode::unreadable_file, "standard output: cannot be written" + why +
                                            ": check that it is open and that the disk has space"};
  }
  return {ErrorCode::unreadable_file,
          name + ": cannot be written" + why +
              ": check that its folder exists and that the disk has space"};
}

Result<void> flush_standard_output() {
  std::cout.flush();
  if (std::cout) return {};
  return unwritable(kStandardOutput);
}

std::ostream& words_beside(std::initializer_list<std::string> outputs) {
  const bool taken = std::any_of(outputs.begin(), outputs.end(), is_standard_output);
  return taken ? std::cerr : std::cout;
}

void print_written(const std::string& name, std::ostream& words) {
  if (!name.empty() && !is_standard_output(name))
    words << "wrote " << text::printable(name) << '\n';
}

}  // namespace pelt::tools::output
