#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace pelt::detail {

/// Allocates pieces of memory that are all released at once. Keeps its blocks, so it allocates
/// nothing if no more memory is needed than before.
class Arena {
 public:
  /// Alignment of every piece.
  static constexpr std::size_t kAlignment = 64;

  /// Memory used by a piece of `bytes`.
  static constexpr std::size_t size_of_piece(std::size_t bytes) {
    return (bytes + kAlignment - 1) / kAlignment * kAlignment;
  }

  /// Returns uninitialised memory, valid until `clear`.
  std::byte* allocate(std::size_t bytes) {
    bytes = size_of_piece(bytes);
    if (bytes > left_) next_block(bytes);
    std::byte* piece = next_;
    next_ += bytes;
    left_ -= bytes;
    return piece;
  }

  /// Returns memory for one `T` with a trivial constructor.
  template <typename T>
  T* allocate() {
    static_assert(alignof(T) <= kAlignment);
    return new (allocate(sizeof(T))) T;
  }

  /// Releases all pieces.
  void clear() {
    block_ = 0;
    next_ = nullptr;
    left_ = 0;
  }

  /// Bytes of all blocks, used or not.
  std::size_t capacity() const;

  /// Bytes allocated since `clear`, including gaps between pieces.
  std::size_t used() const;

  /// Increases the capacity to at least `bytes`. Pieces leave the ends of blocks unused, so pieces
  /// of `bytes` in total may need a little more. If the arena had no memory before, its first block
  /// fits exactly `bytes`.
  void reserve(std::size_t bytes);

 private:
  struct Release {
    void operator()(std::byte* memory) const;
  };

  struct Block {
    std::unique_ptr<std::byte, Release> memory;
    std::size_t size = 0;
  };

  void next_block(std::size_t bytes);
  void add_block(std::size_t bytes);

  std::vector<Block> blocks_;
  std::size_t block_ = 0;  // blocks before this one are in use
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace pelt::detail
