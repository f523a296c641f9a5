#include "tools/pelt/query/pair_list.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>

namespace pelt::tools::query {
namespace {

bool is_nearer(const PairDistance& x, const PairDistance& y) {
  return std::tie(x.distance.distance, x.a, x.b) < std::tie(y.distance.distance, y.a, y.b);
}

/// Number of pairs in one access to the file.
constexpr std::size_t kBlock = 1024;

static_assert(std::is_trivially_copyable_v<PairDistance>, "the file stores the bytes of pairs");

}  // namespace

void LeastDistances::add(const PairDistance& pair) {
  const bool is_beyond = pairs_.size() == most_ && !is_nearer(pair, pairs_.back());
  if (is_beyond && has_left_out_) return;
  const auto known = std::find_if(pairs_.begin(), pairs_.end(), [&](const PairDistance& other) {
    return other.a == pair.a && other.b == pair.b;
  });
  if (known != pairs_.end()) {
    if (!is_nearer(pair, *known)) return;
    pairs_.erase(known);
  } else if (pairs_.size() == most_) {
    has_left_out_ = true;
    if (is_beyond) return;
  }
  pairs_.insert(std::upper_bound(pairs_.begin(), pairs_.end(), pair, is_nearer), pair);
  if (pairs_.size() > most_) pairs_.pop_back();
}

/// Swaps, so that the destructor of `other` closes the file of this.
TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(error_, other.error_);
  return *this;
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void TemporaryFile::append(std::span<const std::byte> bytes) {
  if (descriptor_ < 0 && error_ == 0) open();
  while (!bytes.empty() && error_ == 0) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (written < 0) {
      if (errno != EINTR) fail(errno);
      continue;
    }
    size_ += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

bool TemporaryFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty() && error_ == 0) {
    const ssize_t count =
        ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail(count < 0 ? errno : EIO);  // nothing else shortens the file
    } else {
      offset += static_cast<std::uint64_t>(count);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  return error_ == 0;
}

void TemporaryFile::clear() {
  size_ = 0;
  if (descriptor_ >= 0 && ::ftruncate(descriptor_, 0) != 0) fail(errno);
}

Result<void> TemporaryFile::status() const {
  if (error_ == 0) return {};
  return Error{ErrorCode::unreadable_file,
               folder_.string() +
                   ": cannot hold a temporary file: " + std::generic_category().message(error_) +
                   ": check the folder and its space, or set TMPDIR to another folder"};
}

void TemporaryFile::open() {
  std::error_code unusable;
  folder_ = std::filesystem::temp_directory_path(unusable);
  if (unusable) {
    const char* chosen = ::getenv("TMPDIR");
    folder_ = chosen == nullptr ? "/tmp" : chosen;
    return fail(unusable.value());
  }
  std::string name = folder_ / "pelt-XXXXXX";
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) return fail(errno);
  ::unlink(name.c_str());
}

void TemporaryFile::fail(int error) const {
  if (error_ == 0) error_ = error;
}

void PairList::clear() {
  first_.clear();
  last_.clear();
  file_.clear();
  in_file_ = 0;
}

void PairList::push_back(const PairDistance& pair) {
  if (first_.size() < most_) return first_.push_back(pair);
  last_.push_back(pair);
  if (last_.size() < kBlock) return;
  file_.append(std::as_bytes(std::span(last_)));
  in_file_ += last_.size();
  last_.clear();
}

std::span<const PairDistance> PairList::read(std::size_t index,
                                             std::vector<PairDistance>& buffer) const {
  if (index < first_.size()) return first().subspan(index);
  index -= first_.size();
  if (index >= in_file_) return std::span(last_).subspan(index - in_file_);
  buffer.resize(std::min(kBlock, in_file_ - index));
  const bool is_read =
      file_.read(index * sizeof(PairDistance), std::as_writable_bytes(std::span(buffer)));
  return is_read ? std::span<const PairDistance>(buffer) : std::span<const PairDistance>();
}

const PairDistance* PairReader::next() {
  if (pairs_.empty()) {
    pairs_ = list_.read(index_, buffer_);
    index_ += pairs_.size();
    if (pairs_.empty()) return nullptr;
  }
  const PairDistance* pair = pairs_.data();
  pairs_ = pairs_.subspan(1);
  return pair;
}

}  // namespace pelt::tools::query
