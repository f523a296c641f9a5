#pragma once

/// All that a refit reads of a node, in one piece. The sphere tree and its weight bounds have the
/// same data in five places, and the order of refits is unpredictable: with them a refit would wait
/// for memory longer than it computes.

#include "paper/weight_bounds.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace pelt::paper {

/// The constants of a node; its joint sets follow.
struct RefitRecord {
  Sphere rest;
  std::uint32_t first_child = 0;        // 0 in a leaf
  std::uint32_t first_child_words = 0;  // where the first child's record begins
  std::uint32_t set_count = 0;
};

/// A joint set J_i of a record and its corners r_i1 ... r_im.
struct RecordedSet {
  std::uint32_t joint_count, corner_count;
  const float* joints;   // numbers, to be read by as_number
  const float* corners;  // joint_count weights each
};

class RefitRecords {
 public:
  RefitRecords() = default;
  RefitRecords(const SphereTree& tree, const WeightBounds& bounds);

  /// Reads a record once, from beginning to end.
  class Reader {
   public:
    explicit Reader(const float* words) : word_(words + sizeof(RefitRecord) / sizeof(float)) {
      std::memcpy(static_cast<void*>(&record), words, sizeof record);
    }

    RecordedSet next_set() {
      RecordedSet set = {as_number(word_[0]), as_number(word_[1]), word_ + 2, nullptr};
      set.corners = set.joints + set.joint_count;
      word_ = set.corners + set.joint_count * set.corner_count;
      return set;
    }

    RefitRecord record;

   private:
    const float* word_;
  };

  Reader of(std::uint32_t node) const { return Reader(words_.data() + begin_[node]); }

  /// Call some time before the children of a node are read.
  void prefetch_children(const RefitRecord& record) const;

  static std::uint32_t as_number(float word) { return std::bit_cast<std::uint32_t>(word); }

 private:
  RefitRecord make_record(const Node& node, std::span<const JointSet> sets) const;
  void append(const RefitRecord& record);
  void append(const JointSet& set, const WeightBounds& bounds);
  void append(std::uint32_t number) { words_.push_back(std::bit_cast<float>(number)); }

  std::vector<std::uint32_t> begin_;  // [nodes], into words_
  std::vector<float> words_;          // weights, and numbers in the same four bytes
};

}  // namespace pelt::paper
