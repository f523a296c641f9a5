#pragma once

/// Finds the touching triangles of two clusters whose boxes overlap. Triangles outside of the
/// intersection of the two boxes are skipped. The boxes of the others are tested one against
/// sixteen. The remaining pairs wait until there are eight for the certified float test
/// (triangle_triage.hpp). The exact predicate decides the few lanes that this test leaves
/// undecided.

#include <pelt/query.hpp>

#include "base/instruction_set.hpp"
#include "query/slots.hpp"
#include "query/stack.hpp"
#include "query/triangle_batch.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A list of pairs of a row and a lane, both below 16, written without branches. The number of
/// lanes that a test leaves of a row is random, so a branch would often be mispredicted, which
/// costs more than the test.
class RowLanes {
 public:
  /// Adds the row with each lane whose bit is set.
  void add(unsigned row, unsigned lanes) {
    append(row << 4, lanes & 0xFF);
    append(row << 4 | 8, lanes >> 8);
  }

  std::uint32_t size() const { return size_; }
  unsigned row(std::uint32_t i) const { return pairs_[i] >> 4; }
  unsigned lane(std::uint32_t i) const { return pairs_[i] & 15; }

 private:
  /// For each byte, the indices of its set bits, lowest first, one byte each.
  static constexpr std::array<std::uint64_t, 256> kSetBits = [] {
    std::array<std::uint64_t, 256> numbers{};
    for (unsigned byte = 0; byte < 256; ++byte)
      for (unsigned bit = 0, place = 0; bit < 8; ++bit)
        if (byte >> bit & 1) numbers[byte] |= std::uint64_t{bit} << 8 * place++;
    return numbers;
  }();

  /// Always writes eight pairs; those beyond the set bits are overwritten by the next.
  void append(std::uint64_t pair, unsigned byte) {
    const std::uint64_t eight = kSetBits[byte] + pair * 0x0101010101010101;
    std::memcpy(pairs_ + size_, &eight, sizeof eight);
    size_ += static_cast<std::uint32_t>(std::popcount(byte));
  }

  std::uint32_t size_ = 0;
  std::uint8_t pairs_[16 * 16 + 8];
};

/// Pairs of triangles of two posed trees that wait until there are eight to test.
class WaitingPairs {
 public:
  WaitingPairs(const Tree& tree_a, const Tree& tree_b) : a_(tree_a), b_(tree_b) {}

  std::uint32_t count() const { return count_; }
  Contact contact(std::uint32_t i) const { return {a_.id(i), b_.id(i)}; }

  /// Adds the pairs of triangles of two clusters whose boxes overlap.
  void add(const PosedCluster& a, const PosedCluster& b);

  /// Adds these pairs: rows are triangles of `a`, lanes triangles of `b`.
  void add(const PosedCluster& a, const PosedCluster& b, const RowLanes& pairs) {
    add(pairs, a, a_, b, b_);
  }

  /// Intersecting pairs of eight, one bit each: by the float test, and by the exact predicate.
  struct Found {
    unsigned certainly, exactly;
  };

  /// Tests `count` pairs, at most eight, from number `first` on.
  Found test(std::uint32_t first, std::uint32_t count);

  /// Removes the pairs below number `first`.
  void drop(std::uint32_t first);

 private:
  static constexpr std::uint32_t kRoom = kBatch + kMaxClusterTriangles * kMaxClusterTriangles;

  /// Triangles of one side of the waiting pairs.
  struct Side {
    explicit Side(const Tree& t) : tree(t) {}

    const float* corner(std::uint32_t i, std::size_t k) const {
      return positions[i] + tree.corners[triangle[i]][k];
    }
    TriangleCorners corners(std::uint32_t i) const;
    void corners8(std::uint32_t first, Points8 (&corners)[3]) const;
    std::uint32_t id(std::uint32_t i) const { return tree.triangle_ids[triangle[i]]; }

    void copy(std::uint32_t from, std::uint32_t to) {
      triangle[to] = triangle[from];
      positions[to] = positions[from];
    }

    const Tree& tree;
    std::uint32_t triangle[kRoom];  ///< into Tree::corners
    const float* positions[kRoom];  ///< posed pool of the triangle
  };

  void add(const RowLanes& pairs, const PosedCluster& row_cluster, Side& rows,
           const PosedCluster& lane_cluster, Side& lanes);

  Side a_, b_;
  std::uint32_t count_ = 0;
};

/// Pushes the touching triangles of pairs of clusters to a sink: `sink.push(contact)`.
template <typename Sink>
class TrianglePairs {
 public:
  TrianglePairs(const Tree& tree_a, const Tree& tree_b, Sink& sink, QueryStats& work)
      : waiting_(tree_a, tree_b), sink_(sink), work_(work) {}

  /// Tests all triangles of two clusters whose boxes overlap, or stores them for the next test.
  void add(const PosedCluster& a, const PosedCluster& b) {
    waiting_.add(a, b);
    test_full_batches();
  }

  /// Tests these pairs of triangles, or stores them: rows are triangles of `a`, lanes triangles of
  /// `b`.
  void add(const PosedCluster& a, const PosedCluster& b, const RowLanes& pairs) {
    waiting_.add(a, b, pairs);
    test_full_batches();
  }

  /// Tests the stored pairs.
  void flush() {
    if (waiting_.count() == 0) return;
    test(0, waiting_.count());
    waiting_.drop(waiting_.count());
  }

  /// Number of stored pairs.
  std::uint32_t waiting() const { return waiting_.count(); }

 private:
  void test_full_batches() {
    if (waiting_.count() < kBatch) return;
    std::uint32_t first = 0;
    for (; first + kBatch <= waiting_.count(); first += kBatch) test(first, kBatch);
    waiting_.drop(first);
  }

  void test(std::uint32_t first, std::uint32_t count) {
    const WaitingPairs::Found found = waiting_.test(first, count);
    for (SetBits lane(found.certainly); lane; ++lane) sink_.push(waiting_.contact(first + *lane));
    for (SetBits lane(found.exactly); lane; ++lane) sink_.push(waiting_.contact(first + *lane));
    work_.triangle_pairs += count;
  }

  WaitingPairs waiting_;
  Sink& sink_;
  QueryStats& work_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
