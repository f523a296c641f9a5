#include "tools/pelt/query/pair_list.hpp"

#include <algorithm>
#include <type_traits>

namespace pelt::tools::query {
namespace {

/// Number of pairs in one access to the file.
constexpr std::size_t kBlock = 1024;

static_assert(std::is_trivially_copyable_v<PairDistance>, "the file stores the bytes of pairs");

}  // namespace

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
