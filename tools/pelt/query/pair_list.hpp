#pragma once

/// Lists of the distances of pairs of colliders.

#include <pelt/distance.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace pelt::tools::query {

/// The distance of two colliders a < b in one frame.
struct PairDistance {
  std::uint32_t a = 0, b = 0;
  Distance distance = {};
  std::uint32_t frame = 0;
};

/// The closest pairs, each once, with its least distance. Stores at most a fixed number of pairs.
class LeastDistances {
 public:
  /// Stores at most `most` pairs.
  explicit LeastDistances(std::size_t most) : most_(most) {}

  void clear() { pairs_.clear(); }

  /// Adds a pair. If it was added before with an equal distance, the earlier one stays.
  void add(const PairDistance& pair);

  /// Whether pairs were left out since the construction because there were too many.
  bool has_left_out() const { return has_left_out_; }

  /// Sorted by distance, then a, then b.
  std::span<const PairDistance> pairs() const { return pairs_; }

 private:
  std::size_t most_;
  bool has_left_out_ = false;
  std::vector<PairDistance> pairs_;
};

/// A file for results that do not fit in memory, in the folder TMPDIR, or /tmp. The file has no
/// name, so the system frees it when the process ends, whatever ends it. The first `append` creates
/// the file.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  TemporaryFile(TemporaryFile&& other) noexcept { *this = std::move(other); }
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;
  ~TemporaryFile();

  /// Does nothing after a failure.
  void append(std::span<const std::byte> bytes);

  /// Copies `bytes.size()` bytes from `offset`. Returns false if this or anything earlier failed.
  bool read(std::uint64_t offset, std::span<std::byte> bytes) const;

  /// Removes the content.
  void clear();

  /// Error that names the folder if anything failed.
  Result<void> status() const;

 private:
  void open();
  void fail(int error) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  mutable int error_ = 0;  // errno of the first failure
};

/// A list of pairs that is written and read in order. The first pairs are in memory, all others in
/// a temporary file.
class PairList {
 public:
  /// Stores at most `most` pairs in memory, apart from small buffers.
  explicit PairList(std::size_t most) : most_(most) {}

  void clear();
  void push_back(const PairDistance& pair);
  std::size_t size() const { return first_.size() + in_file_ + last_.size(); }

  /// The first pairs, up to the maximum in memory.
  std::span<const PairDistance> first() const { return first_; }

  /// Pairs from `index` on: at least one if there are any. `buffer` is for those that are read from
  /// the file. Empty at the end, and after a failure.
  std::span<const PairDistance> read(std::size_t index, std::vector<PairDistance>& buffer) const;

  /// Error if the temporary file could not be written or read.
  Result<void> status() const { return file_.status(); }

 private:
  std::size_t most_;
  std::vector<PairDistance> first_;
  TemporaryFile file_;
  std::size_t in_file_ = 0;         // number of pairs
  std::vector<PairDistance> last_;  // not yet in the file
};

/// Reads the pairs of a list in order.
class PairReader {
 public:
  /// The list must not change while it is read.
  explicit PairReader(const PairList& list) : list_(list) {}

  /// Null at the end. Valid until the next call.
  const PairDistance* next();

 private:
  const PairList& list_;
  std::size_t index_ = 0;  // of the first pair after `pairs_`
  std::span<const PairDistance> pairs_;
  std::vector<PairDistance> buffer_;
};

}  // namespace pelt::tools::query
