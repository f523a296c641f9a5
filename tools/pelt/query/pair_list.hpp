#pragma once

#include "tools/pelt/output/temporary_file.hpp"
#include "tools/pelt/query/least_distances.hpp"

#include <vector>

namespace pelt::tools::query {

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
  output::TemporaryFile file_;
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
