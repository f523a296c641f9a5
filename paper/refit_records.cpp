#include "paper/refit_records.hpp"

#include "paper/prefetch.hpp"

namespace pelt::paper {
namespace {

/// Most families of siblings are no larger; the processor prefetches the memory that follows.
constexpr std::uint32_t kPrefetchedWords = 64, kWordsInCacheLine = 16;

std::uint32_t size_of_record(std::span<const JointSet> sets) {
  std::uint32_t size = sizeof(RefitRecord) / sizeof(float);
  for (const JointSet& set : sets) size += 2u + set.joint_count * (1u + set.corner_count);
  return size;
}

}  // namespace

RefitRecords::RefitRecords(const SphereTree& tree, const WeightBounds& bounds) {
  std::uint32_t size = 0;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    begin_.push_back(size);
    size += size_of_record(bounds.sets_of(n));
  }
  words_.reserve(size + kPrefetchedWords);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    append(make_record(tree.nodes[n], bounds.sets_of(n)));
    for (const JointSet& set : bounds.sets_of(n)) append(set, bounds);
  }
  words_.resize(size + kPrefetchedWords);
}

RefitRecord RefitRecords::make_record(const Node& node, std::span<const JointSet> sets) const {
  RefitRecord record;
  record.rest = node.rest;
  record.first_child = node.first_child;
  record.first_child_words = begin_[node.first_child];
  record.set_count = static_cast<std::uint32_t>(sets.size());
  return record;
}

void RefitRecords::append(const RefitRecord& record) {
  const std::size_t begin = words_.size();
  words_.resize(begin + sizeof record / sizeof(float));
  std::memcpy(&words_[begin], &record, sizeof record);
}

void RefitRecords::append(const JointSet& set, const WeightBounds& bounds) {
  append(set.joint_count);
  append(set.corner_count);
  for (std::uint32_t j = 0; j < set.joint_count; ++j) append(bounds.joints[set.first_joint + j]);
  const auto corners = bounds.corners.begin() + set.first_corner;
  words_.insert(words_.end(), corners,
                corners + std::ptrdiff_t{set.joint_count} * set.corner_count);
}

void RefitRecords::prefetch_children(const RefitRecord& record) const {
  prefetch(&begin_[record.first_child]);
  const float* words = words_.data() + record.first_child_words;
  for (std::uint32_t i = 0; i < kPrefetchedWords; i += kWordsInCacheLine) prefetch(words + i);
}

}  // namespace pelt::paper
