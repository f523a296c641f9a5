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
    if (replaced_ > 0) release_replaced();
    block_ = 0;
    next_ = nullptr;
    left_ = unused_ = 0;
  }

  /// Bytes of all blocks, used or not.
  std::size_t capacity() const;

  /// Bytes of the pieces allocated since `clear`.
  std::size_t used() const;

  /// The largest total size of pieces, of any sizes in any order, that need no allocation after
  /// `clear`: that of the largest block, because pieces leave the ends of blocks unused.
  std::size_t room() const;

  /// Ensures that there is room for `bytes`. A new block replaces all others, which the next
  /// `clear` frees. In an arena without memory, the new block holds exactly `bytes`, and can be
  /// used at once.
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
  void release_replaced();

  std::vector<Block> blocks_;
  std::size_t replaced_ = 0;  // blocks before this one are freed by `clear`
  std::size_t block_ = 0;     // blocks before this one are in use
  std::size_t unused_ = 0;    // bytes at the ends of those blocks, and of blocks passed over
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace pelt::detail
