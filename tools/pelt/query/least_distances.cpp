#include "tools/pelt/query/least_distances.hpp"

#include <algorithm>
#include <tuple>

namespace pelt::tools::query {
namespace {

bool is_nearer(const PairDistance& x, const PairDistance& y) {
  return std::tie(x.distance.distance, x.a, x.b) < std::tie(y.distance.distance, y.a, y.b);
}

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

}  // namespace pelt::tools::query
